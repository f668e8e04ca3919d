// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>

#include "router_store.hpp"
#include "runtime/middleware/link_bus.hpp"

namespace tocsin {

/// What this host keeps of what peers send: topics that the traffic file lists under `keep` go to
/// its history as they are given to the host, live or backfilled, for readers that come late.
class ArrivalLog {
 public:
  /// All outlive it. `wall_ns`: [ns] since the Unix epoch, of a time.
  struct Parts {
    LinkBus& link;
    RouterStore& history;
    std::function<std::int64_t(Time)> wall_ns;
  };
  explicit ArrivalLog(Parts parts) : parts_(std::move(parts)) {}

  /// Whether it keeps anything.
  [[nodiscard]] bool keeps_any() const { return parts_.link.rules().keeps_any(); }
  /// A sample of a peer's flow that the host is given for the first time.
  void keep(const Flow& flow, const CarriedSample& sample, Time now);

 private:
  const Parts parts_;
  std::set<std::string> known_;  ///< streams that the history was told of
};

}  // namespace tocsin
