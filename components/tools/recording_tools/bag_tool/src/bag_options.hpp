// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "player.hpp"
#include "recording.hpp"
#include "rewrite.hpp"
#include "runtime/middleware/host_bus.hpp"

namespace CLI {
class App;
}

namespace tocsin::bag_tool {

/// What a person said after `tocsin bag`.
struct Options {
  HostChoice host;
  double spin_s = 2;
  RecordOrder record;
  PlayOrder play;
  RewriteOrder rewrite;
  std::vector<std::string> remap;
  std::string clock_hz;  ///< empty with --clock alone
  bool clock = false;
  std::string bag;     ///< info, recover
  std::string output;  ///< of what makes a bag
  std::string compression_mode;
  std::string compression_format;
  bool no_discovery = false;
  int polling_interval_ms = 100;
};

/// Declares the verbs and their options.
void declare(CLI::App& app, Options& options);

/// Puts together what several options say. Throws ConfigError for what contradicts itself.
void complete(const std::string& verb, Options& options);

}  // namespace tocsin::bag_tool
