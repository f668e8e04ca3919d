// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "foundation/instant.hpp"
#include "link_tables.hpp"
#include "runtime/middleware/link_bus.hpp"

namespace tocsin {

/// Who notes what the host was delivered, so that nothing is delivered twice.
class Deliveries {
 public:
  virtual ~Deliveries() = default;
  /// Samples of a peer's stored flow will follow.
  virtual void expect(Instant at) = 0;
  /// A sample of a stored flow was received live. Whether it is the first time.
  [[nodiscard]] virtual bool on_live(const LinkPeer& peer, const RemoteFlow& flow,
                                     const CarriedSample& sample) = 0;
  /// The host is delivered a sample of a peer's flow for the first time.
  virtual void on_delivery(const Flow& what, const CarriedSample& sample, Instant at) = 0;
};

}  // namespace tocsin
