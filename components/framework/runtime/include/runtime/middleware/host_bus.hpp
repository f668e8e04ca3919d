// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "runtime/middleware/fast_dds_bus.hpp"

namespace CLI {
class App;
}
namespace tocsin::deployment {
struct RunningHost;
}

namespace tocsin {

/// Which running host a command of the user talks to.
struct HostChoice {
  /// Its host domain; empty: of `run_dir`, else $ROS_DOMAIN_ID, else of the one run on this
  /// computer, else 0.
  std::optional<int> domain = std::nullopt;
  std::string run_dir = "";  ///< of a `tocsin launch`; empty: none is named
  std::string host = "";     ///< of that run; empty: the first one
  std::string ros_namespace = "";

  /// Adds --domain, --run-dir, --host and --namespace to a command.
  void declare(CLI::App& app);
  /// A name such as /gcs/link chooses the host that it begins with, unless --host does.
  void adopt_host_of(const std::string& name);
};

/// $ROS_DOMAIN_ID, or 0. Throws ConfigError when it is no domain id.
[[nodiscard]] int default_domain();

/// The host of a `tocsin launch` that is chosen; null: only a domain is, or nothing runs. Throws
/// ConfigError for a wrong choice, EnvironmentError when nothing runs in the folder that it names.
[[nodiscard]] std::unique_ptr<deployment::RunningHost> chosen_host(const HostChoice& choice);

/// How to join the host's domain as `name`. Enters the host's network namespace when the run gave
/// it one: call it before the program has a second thread. Throws ConfigError for a wrong choice,
/// EnvironmentError when the namespace cannot be entered.
[[nodiscard]] BusOptions host_bus_options(const HostChoice& choice, const std::string& name);

/// Joins the host's domain as `name`, in the host's network namespace when the run gave it one.
/// Call it before the program has a second thread. Throws ConfigError for a wrong choice,
/// EnvironmentError when the namespace cannot be entered.
[[nodiscard]] std::unique_ptr<Bus> open_host_bus(const HostChoice& choice, const std::string& name);

}  // namespace tocsin
