// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <list>
#include <memory>
#include <vector>

#include "deployment/deployment.hpp"
#include "runner.hpp"
#include "runtime/middleware/gate_component.hpp"

namespace tocsin {

/// The components of one process, each on a thread of its own.
class Container {
 public:
  /// Builds every component. Throws ConfigError or EnvironmentError; nothing runs then.
  /// `request_exit` is called from a component's thread.
  Container(const deployment::Deployment& deployment, const deployment::Host& host,
            const deployment::Container& container, std::function<void(int)> request_exit);
  /// Stops all threads, then destroys the components in reverse order.
  ~Container();

  void start();

 private:
  struct Instance {
    std::unique_ptr<Context> context;
    std::unique_ptr<Component> component;
    TickAccount account;
    std::unique_ptr<Runner> runner;
  };
  Instance& add_instance(const std::string& name);

  const deployment::Deployment& deployment_;
  const deployment::Host& host_;
  std::function<void(int)> request_exit_;
  std::unique_ptr<Bus> bus_;
  std::list<Instance> instances_;
};

}  // namespace tocsin
