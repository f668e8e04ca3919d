// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "running_system.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"

namespace tocsin {

/// Where an order about the emergency stop is given.
struct EstopTarget {
  std::string name;              ///< to tell people
  std::optional<pid_t> process;  ///< whose network is entered first
  BusOptions bus;                ///< with built-in QoS; a file is read for an own router only
  /// The vehicle listens to routers only, and the station's does not run: the order needs its own.
  bool needs_router = false;
  std::string choice = {};  ///< the options that mean it alone; empty: those that were given
};

/// How tocsin estop finds its station.
struct EstopOptions {
  JoinOptions join;
  // In place of a run: names one by its DDS domains.
  std::optional<int> domain;       ///< of the station's host
  std::optional<int> link_domain;  ///< of the topics that cross the radio
  std::string address;             ///< own IPv4 on the link
  std::vector<std::string> peers;
  std::string enclave;  ///< folder of the own identity on a secured link
  std::string ros_namespace;
  bool all = false;  ///< a release, too, is for every station that runs here

  void declare(CLI::App& app);
};

enum class Among { all, only_one };

/// The vehicles that are meant, each at its station: those that the options name, else those whose
/// stations run on this computer, else those of the last run here, which can still reach the
/// vehicle. Needs no file, except the last one. Throws EnvironmentError when there is none,
/// ConfigError for options that do not fit together and, with `only_one`, when several run and the
/// options choose neither one nor all.
[[nodiscard]] std::vector<EstopTarget> find_targets(const EstopOptions& options, Among among,
                                                    deployment::RunningHosts running);

}  // namespace tocsin
