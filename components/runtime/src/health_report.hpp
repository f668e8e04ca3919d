// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ros_idl/diagnostic_msgs.hpp"
#include "runtime/component.hpp"
#include "tick_account.hpp"

namespace tocsin {

/// When the health of a container's parts is no longer fine.
struct HealthLimits {
  double period_s = 1.0;
  double slow_tick_s = 0.5;
  double blocked_tick_s = 5.0;
  double overrun_share = 0.1;
  double resident_mib = 512;
  double growth_mib = 64;
  double disk_low_mib = 100;
  template <class Visitor>
  void visit(Visitor& v) {
    v("period_s", period_s, {0.1, 60}, "[s] between reports");
    v("slow_tick_s", slow_tick_s, {0.001, 3600}, "[s] a longer tick is a WARN");
    v("blocked_tick_s", blocked_tick_s, {0.001, 3600}, "[s] a tick that runs longer is an ERROR");
    v("overrun_share", overrun_share, {0, 1}, "[1] a larger share of skipped periods is a WARN");
    v("resident_mib", resident_mib, {1, 1e6}, "[MiB] more resident memory is a WARN");
    v("growth_mib", growth_mib, {1, 1e6}, "[MiB] memory that grew by more is a WARN");
    v("disk_low_mib", disk_low_mib, {0, 1e9}, "[MiB] less room on the run folder's disk is a WARN");
  }
};

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

/// Resident memory of the process, and room for its files.
struct ProcessFigures {
  std::uint64_t bytes = 0;
  std::uint64_t first_bytes = 0;  ///< once it had settled
  std::string run_dir;
  std::optional<std::uint64_t> free_bytes;  ///< on its disk; empty: it is not known
};

using Diagnostic = diagnostic_msgs::msg::DiagnosticStatus;

/// Pure: figures and limits in, a status out. Names are "container/instance".
[[nodiscard]] Diagnostic diagnose(const std::string& container, const InstanceHealth& instance,
                                  const HealthLimits& limits);
[[nodiscard]] Diagnostic diagnose(const std::string& container, const ProcessFigures& process,
                                  const HealthLimits& limits);
[[nodiscard]] Diagnostic diagnose(const std::string& container, const EndpointHealth& endpoint,
                                  const EndpointHealth& before);
/// False for an endpoint without an event, of which nothing is told.
[[nodiscard]] bool is_eventful(const EndpointHealth& endpoint);

}  // namespace tocsin
