// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "deployment/deployment.hpp"
#include "ros_idl/diagnostic_msgs.hpp"
#include "rtps_filter/drop_account.hpp"
#include "runtime/component.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/refused_names.hpp"
#include "runtime/middleware/tick_account.hpp"

namespace tocsin {

using deployment::HealthLimits;

/// Sums of one instance at one instant.
struct InstanceSums {
  Time at{};
  TickFigures ticks;
  std::uint64_t overruns = 0;
  std::vector<PortHealth> ports;
};

/// What is told of one instance.
struct InstanceHealth {
  std::string name;
  std::string state;
  std::string error;
  std::string twin;  ///< container that has another instance of this name; empty: none
  InstanceSums before;
  InstanceSums now;
};

/// Resident memory of the process, its threads, and room for its files.
struct ProcessFigures {
  std::uint64_t bytes = 0;
  std::uint64_t first_bytes = 0;  ///< once it had settled
  std::string run_dir;
  std::optional<std::uint64_t> free_bytes;  ///< on its disk; empty: it is not known
  std::optional<std::string> finding = {};  ///< what is wrong with its threads
};

using Diagnostic = diagnostic_msgs::msg::DiagnosticStatus;

/// Pure: figures and limits in, a status out. Names are "container/instance".
[[nodiscard]] Diagnostic diagnose(const std::string& container, const InstanceHealth& instance,
                                  const HealthLimits& limits);
[[nodiscard]] Diagnostic diagnose(const std::string& container, const ProcessFigures& process,
                                  const HealthLimits& limits);
[[nodiscard]] Diagnostic diagnose(const std::string& container, const EndpointHealth& endpoint,
                                  const EndpointHealth& before);
/// Packets that this process was not shown: a finding while some are dropped, sums as history.
[[nodiscard]] Diagnostic diagnose(const std::string& container,
                                  const rtps_filter::DropAccount& dropped,
                                  const rtps_filter::DropAccount& before);
/// Names that this process's router did not take from the link, in the same way.
[[nodiscard]] Diagnostic diagnose(const std::string& container, const RefusedNames& refused,
                                  const RefusedNames& before);
/// False for an endpoint without an event, of which nothing is told.
[[nodiscard]] bool is_eventful(const EndpointHealth& endpoint);

}  // namespace tocsin
