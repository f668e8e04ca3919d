// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "link_router/reader_wait.hpp"
#include "runtime/middleware/link_bus.hpp"

namespace tocsin {

/// What is received on a peer's stored flow before readers of the host have found its writer there.
/// It waits for them, and no acknowledgement names it until it is delivered: what this router does
/// not deliver before it ends is backfilled. Pure; `now` never decreases.
class HeldArrivals {
 public:
  /// The flow's writer on the host is made now.
  void expect(FlowId flow, Time now);
  void on_reader(FlowId flow, Time now);
  void forget(FlowId flow) { flows_.erase(flow); }

  /// Whether it is held, or left to be backfilled since too many are. Else it may be delivered.
  [[nodiscard]] bool hold(const link_event::LinkSample& sample);
  /// What may be delivered now, in the order of each flow; its flows hold nothing any more.
  [[nodiscard]] std::vector<link_event::LinkSample> take(Time now);
  /// When take() has something though nothing happens.
  [[nodiscard]] Time deadline() const;

 private:
  struct Waiting {
    router::ReaderWait wait;
    std::vector<link_event::LinkSample> samples{};
  };
  std::map<FlowId, Waiting> flows_;
};

}  // namespace tocsin
