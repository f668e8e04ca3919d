// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "files.hpp"
#include "geometry/pose.hpp"
#include "kobuki_model/base_settings.hpp"
#include "laser_model/room.hpp"
#include "laser_terminal.hpp"

namespace tocsin::kobuki {

/// The command line. Paths are empty when not given.
struct Options {
  std::string link;
  std::string walls;
  std::string obstacles;
  geometry::Pose start;
  std::optional<geometry::Pose> dock;
  std::uint64_t seed = 1;
  BaseSettings settings;
  LaserTerminal::Params laser;  ///< no link: none
  std::string position;
  std::string control;
  std::string state;
  std::string script;  ///< the text of the file
  std::string script_file;
  bool check = false;  ///< only look at the arguments and the files
};

/// Empty with an exit code in `exit_code` when the program shall end at once (help, bad usage).
/// Throws ConfigError for bad files and values.
[[nodiscard]] std::optional<Options> parse_options(int argc, const char* const* argv,
                                                   int& exit_code);

/// Where it is. Throws ConfigError for bad files.
[[nodiscard]] laser::Room make_room(const Options& options);
/// The base that the options describe, powered on at `now`, where an earlier run left it if there
/// is a state file. Throws ConfigError, also when it would stand in a wall.
[[nodiscard]] BaseModel make_model(const Options& options, const laser::Room& room, Time now);

}  // namespace tocsin::kobuki
