// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "graph.hpp"
#include "runtime/bus.hpp"
#include "runtime/middleware/idle_link_bus.hpp"

namespace tocsin::check {

/// A bus without a wire: it only writes down which ports a component makes.
class PortRecorder final : public Bus {
 public:
  std::unique_ptr<Subscription> subscribe(const Endpoint& endpoint, Receiver& receiver) override;
  std::unique_ptr<Publication> advertise(const Endpoint& endpoint) override;
  [[nodiscard]] Time now() const override { return {}; }
  [[nodiscard]] std::int64_t wall_ns(Time t) const override { return t.time_since_epoch().count(); }
  std::unique_ptr<LinkBus> open_link(const std::function<void()>&) override {
    return std::make_unique<IdleLinkBus>(TrafficRules());
  }

  /// What the writer of a topic expects to write.
  void expect(const std::string& topic, const ExpectedLoad& load);
  /// The ports made so far, in the order of their making. Ends that say the same of a topic are
  /// one, with what the more demanding of them needs; ends that disagree stay apart, to be found.
  [[nodiscard]] const std::vector<Port>& ports() const { return ports_; }

 private:
  void record(const Endpoint& endpoint, bool writes);
  std::vector<Port> ports_;
};

}  // namespace tocsin::check
