// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>

#include "container/control_component.hpp"
#include "deployment/deployment.hpp"
#include "runner/runner_threads.hpp"
#include "watch/process_watch.hpp"

namespace tocsin {

/// The components of one process, with a control on a thread of its own.
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
  const std::unique_ptr<Bus> bus_;
  Context context_;  ///< of the control; of each component but for the name
  std::unique_ptr<RunnerThreads> threads_;
  std::unique_ptr<Instances> instances_;
  std::unique_ptr<ControlComponent> control_;
  TickAccount control_account_;
  std::unique_ptr<Runner> control_runner_;
  ProcessWatch watch_;  // last: it ends the process when the others cannot go on
};

}  // namespace tocsin
