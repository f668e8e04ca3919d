// SPDX-License-Identifier: Apache-2.0
#include "options.hpp"

#include <CLI/CLI.hpp>

#include "command_line/option_checks.hpp"
#include "foundation/error.hpp"
#include "geometry/wall_file.hpp"
#include "laser_model/obstacle_file.hpp"

namespace tocsin::kobuki {

std::optional<Options> parse_options(int argc, const char* const* argv, int& exit_code) {
  Options options;
  std::string start = "0,0,0";
  std::string dock;
  std::string config;
  std::string mount = "0,0,0";
  CLI::App app("A simulated Kobuki base behind a pseudo-terminal");
  app.add_option("--link", options.link, "symbolic link to the terminal")->required();
  app.add_option("--walls", options.walls, "YAML file of wall segments; none is an open floor");
  app.add_option("--obstacles", options.obstacles, "YAML file of boxes, discs and people who walk");
  app.add_option("--laser", options.laser.link,
                 "symbolic link to the terminal of an RPLIDAR on it");
  app.add_option("--laser-profile", options.laser.profile,
                 "rplidar_a1, rplidar_a2 or kinect (57 degrees)");
  app.add_option("--laser-mount", mount, "X,Y,YAW of the laser on the vehicle in m, m, rad");
  app.add_option("--start", start, "X,Y,YAW in m, m, rad");
  app.add_option("--dock", dock,
                 "X,Y,YAW of a charging dock: middle of its front, facing the room");
  app.add_option("--seed", options.seed, "of all noise")->check(is_seed());
  app.add_option("--config", config, "YAML file with model: and line: parameters");
  app.add_option("--position", options.position, "socket that gets 'pos X Y' at 10 Hz");
  app.add_option("--control", options.control, "socket that takes commands (get, set, unplug ...)");
  app.add_option("--state", options.state, "file to resume from after a restart");
  app.add_option("--script", options.script_file, "file of lines 'SECONDS COMMAND'");
  app.add_flag("--check", options.check, "only look at the arguments and the files that they name");
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    exit_code = app.exit(help);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    throw ConfigError(usage_error(app, error));
  }
  options.start = parse_pose("--start", start);
  options.laser.mount = parse_pose("--laser-mount", mount);
  (void)laser::find_laser_profile(options.laser.profile);
  if (!dock.empty()) options.dock = parse_pose("--dock", dock);
  if (!config.empty()) options.settings = load_base_settings(config);
  if (!options.script_file.empty()) options.script = load_text(options.script_file);
  return options;
}

laser::Room make_room(const Options& options) {
  std::vector<geometry::Wall> walls;
  std::vector<geometry::Wall> low;
  laser::Obstacles obstacles;
  if (!options.walls.empty()) walls = geometry::load_walls(options.walls);
  if (options.dock) low.push_back(Dock(*options.dock).front());
  if (!options.obstacles.empty()) obstacles = laser::load_obstacles(options.obstacles);
  return {walls, low, obstacles};
}

BaseModel make_model(const Options& options, const laser::Room& room, Time now) {
  Surroundings around = room.touched();
  if (!around(options.start.x_m, options.start.y_m, body_radius_m).empty()) {
    throw ConfigError("--start: the base would stand in a wall, an obstacle or the dock");
  }
  BaseModel model(options.settings.model, std::move(around), options.start, options.seed, now);
  if (options.dock) model.set_dock(Dock(*options.dock));
  if (options.state.empty()) return model;
  if (const auto memory = load_memory(options.state)) model.recall(*memory, now);
  return model;
}

}  // namespace tocsin::kobuki
