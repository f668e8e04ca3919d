// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "graph.hpp"
#include "idle_link_bus.hpp"
#include "runtime/bus.hpp"

namespace tocsin::check {

/// A bus without a wire: it only writes down which ports a component makes.
class PortRecorder final : public Bus, private LinkAccess {
 public:
  std::unique_ptr<Subscription> subscribe(const Endpoint& endpoint, Receiver& receiver) override;
  std::unique_ptr<Publication> advertise(const Endpoint& endpoint) override;
  [[nodiscard]] Time now() const override { return {}; }
  [[nodiscard]] std::int64_t wall_ns(Time t) const override { return t.time_since_epoch().count(); }
  [[nodiscard]] LinkAccess* link_access() override { return this; }

  /// The ports made so far, in the order of their making. Ends that say the same of a topic are
  /// one, with what the more demanding of them needs; ends that disagree stay apart, to be found.
  [[nodiscard]] const std::vector<Port>& ports() const { return ports_; }

 private:
  std::unique_ptr<LinkBus> open_link(const std::function<void()>&) override {
    return std::make_unique<IdleLinkBus>(TrafficRules());
  }
  void record(const Endpoint& endpoint, bool writes);
  std::vector<Port> ports_;
};

}  // namespace tocsin::check
