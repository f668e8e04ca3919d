// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

#include "backfill/router_store.hpp"
#include "foundation/instant.hpp"
#include "runtime/middleware/link_bus.hpp"

namespace tocsin {

/// What this host keeps of what peers send: topics that the traffic file lists under `keep` go to
/// its history as they are delivered, live or backfilled, for late readers.
class ArrivalLog {
 public:
  /// Both outlive it.
  ArrivalLog(LinkBus& link, RouterStore& history) : link_(link), history_(history) {}

  [[nodiscard]] bool keeps_any() const { return link_.rules().keeps_any(); }
  /// A sample of a peer's flow that the host is delivered for the first time.
  void keep(const Flow& flow, const CarriedSample& sample, Instant at);

 private:
  LinkBus& link_;
  RouterStore& history_;
  std::set<std::string> known_;  ///< streams that the history knows
};

}  // namespace tocsin
