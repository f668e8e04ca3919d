// SPDX-License-Identifier: Apache-2.0
// Both sides of a node's services in a test: who ticks components, and a person who asks them.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "container/instances.hpp"
#include "runtime/service_port.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {

/// Ticks on the bus of the test.
class SimTicker : public Ticker {
 public:
  explicit SimTicker(SimBus& bus) : bus_(bus) {}
  void add(Component& component, TickAccount&) override { bus_.add(component); }
  bool remove(Component& component) override {
    bus_.remove(component);
    return true;
  }

 private:
  SimBus& bus_;
};

/// A person who asks the services of one node.
template <class Service>
class Asker : private ClientReceiver {
 public:
  Asker(SimBus& bus, const std::string& node) : bus_(bus) {
    const std::string name = Service::name;
    end_ = bus.call({node + name.substr(1), &type_info<typename Service::Request>(),
                     &type_info<typename Service::Response>()},
                    *this);
    bus_.run_for(seconds(2));  // a container looks at its callers once a second at least
  }
  /// Null: nobody serves it, or nobody answers.
  std::shared_ptr<const typename Service::Response> ask(typename Service::Request request) {
    reply_ = nullptr;
    if (!end_->send(std::make_shared<const typename Service::Request>(std::move(request)))) {
      return nullptr;
    }
    bus_.run_for(seconds(0.1));
    return std::static_pointer_cast<const typename Service::Response>(reply_);
  }
  [[nodiscard]] bool available() const { return end_->available(); }

 private:
  void receive(ServiceReply&& reply) override { reply_ = reply.message; }
  void wake() override {}
  SimBus& bus_;
  std::shared_ptr<const void> reply_;
  std::unique_ptr<ClientEnd> end_;
};

}  // namespace tocsin
