// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "command_line/command.hpp"
#include "runtime/middleware/host_bus.hpp"
#include "tune/run_tune.hpp"

namespace tocsin::qos_tool {

/// What a person said after `tocsin qos`.
struct Options {
  HostChoice host;
  double spin_s = 2;
  std::string file;     ///< QoS file; empty: the shipped one
  std::string traffic;  ///< traffic file; empty: the shipped one
  bool json = false;
  bool all = false;
  std::string one;    ///< first name: profile or topic
  std::string other;  ///< second name
  std::vector<std::string> settings;
  std::vector<std::string> profiles;
  std::string vendor = "fastdds";
  bool direct = false;
  std::vector<std::string> streams;
  double outage_s = 10;
  bool clocks_are_synchronised = false;
  TuneOptions tune;
};

/// Declares the verbs and their options.
void declare(Verbs& verbs, Options& options);

}  // namespace tocsin::qos_tool
