// SPDX-License-Identifier: Apache-2.0
// tocsin map: a map of a recorded drive, and drives that cover one.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>

#include "command_line/command.hpp"
#include "cover.hpp"
#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/read_file.hpp"
#include "foundation/replace_file.hpp"
#include "link.hpp"
#include "navigation/map_writer.hpp"
#include "order.hpp"
#include "replay.hpp"
#include "save.hpp"

namespace tocsin::map_tool {
namespace {

constexpr std::size_t longest_log = std::size_t{1} << 31U;  // [byte]

struct Options {
  std::string log;
  std::string trajectory;
  std::string map;
  double resolution_m = 0.05;
  laser::ScanParams scan;
};

void declare(CLI::App& app, Options& options) {
  app.add_option("LOG", options.log,
                 "log in the text format of CARMEN (ODOM with FLASER or ROBOTLASER1)")
      ->required();
  app.add_option("--trajectory", options.trajectory,
                 "file to write: time x y theta of each reading of the odometry");
  app.add_option("--map", options.map, "writes NAME.yaml and NAME.pgm, as ROS's map_server reads")
      ->type_name("NAME");
  app.add_option("--resolution", options.resolution_m, "[m] side of a cell of that map [0.05]")
      ->check(CLI::Range(0.01, 1.0));
  app.add_option("--max-range", options.scan.max_range_m,
                 "[m] this and more is no return, in addition to what the log says [40]")
      ->check(CLI::Range(1.0, 1000.0));
}

void tell(const Replay& replay, double took_s) {
  const auto& mapper = replay.mapper();
  std::printf("%zu scans in %.1f s (%.1f ms each); %zu used, %zu submaps, %zu loops\n",
              replay.scans(), took_s,
              1e3 * took_s / static_cast<double>(std::max<std::size_t>(1, replay.scans())),
              mapper.nodes().size(), mapper.global().submaps().size(), mapper.global().loops());
}

int replay_log(const Options& options) {
  const std::string text = read_file(options.log, longest_log);
  CarmenLog log(text, printable(options.log));
  Replay replay({}, options.scan);
  const auto begin = std::chrono::steady_clock::now();
  while (const auto reading = log.next()) replay.on_reading(*reading);
  if (replay.scans() == 0) {
    throw ConfigError(options.log + ": has no scan; FLASER or ROBOTLASER1 lines are needed");
  }
  replay.finish();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  if (!options.trajectory.empty()) {
    const auto error = replace_file(options.trajectory, trajectory_text(replay.trajectory()));
    if (error) throw ConfigError(options.trajectory + ": cannot be written: " + error.message());
  }
  if (!options.map.empty()) {
    navigation::write_map(replay.mapper().map(options.resolution_m), options.map);
  }
  tell(replay, took.count());
  return 0;
}

void declare(CLI::App& app, CoverOptions& options) {
  auto& params = options.params;
  app.add_option("MAP", options.map, "map in the format of ROS's map_server (YAML)")->required();
  app.add_option("--mission", options.mission, "mission file to write, for tocsin mission")
      ->required();
  app.add_option("--start", options.start, "[m] where the robot is, map frame [0,0]")
      ->type_name("X,Y");
  app.add_option("--polygon", options.polygon,
                 "[m] corners of what is to be covered; default: all that can be reached")
      ->type_name("X,Y");
  app.add_option("--width", params.width_m, "[m] of the tool, in the middle of the robot [0.3]");
  app.add_option("--overlap", params.overlap_m, "[m] of neighbouring swaths, at least [0.04]");
  app.add_option("--soft-weight", params.inflation.soft_weight,
                 "soft_weight of the navigator that drives it [3]")
      ->check(CLI::Range(0.0, 50.0));
  app.add_option("--picture", options.picture, "PGM image to write: map, drive, what is left out");
}

void declare(CLI::App& app, SaveOptions& options) {
  app.add_option("NAME", options.name, "writes NAME.yaml and NAME.pgm")->required();
  app.add_flag("--overwrite", options.overwrite, "replaces files of that name");
  app.add_option("--wait", options.wait_s, "[s] until a map must have come [10]")
      ->check(CLI::Range(0.1, 3600.0));
  options.host.declare(app);
}

int print_save(const SaveOptions& options) {
  std::fputs(save(options).c_str(), stdout);
  return 0;
}

void declare(CLI::App& app, ContinueOptions& options) {
  app.add_option("NAME", options.name, "goes on with NAME.session, and saves there")->required();
  app.add_flag("--by-hand", options.by_hand, "you drive, see tocsin teleop; else it explores");
}

void declare(CLI::App& app, LinkOptions& options) {
  app.add_option("FILE", options.file, "positions with signal, a line each, columns named")
      ->required();
  app.add_option("--columns", options.columns,
                 "names of the columns to take [those that are usual]")
      ->type_name("X,Y,SIGNAL");
  auto* const leave_out =
      app.add_option("--leave-out", options.leave_out, "share of the places, at random [0.25]");
  app.add_option("--after", options.after, "learns from this first share of the way only")
      ->excludes(leave_out);
  app.add_option("--seed", options.seed, "of what is left out [1]");
  app.add_flag("--json", options.json, "one line of JSON");
}

int print_link(const LinkOptions& options) {
  std::fputs(link(options).c_str(), stdout);
  return 0;
}

void declare(CLI::App& app, OrderOptions& options) {
  app.add_option("MISSION", options.mission, "mission file; its first and last waypoint stay")
      ->required();
  app.add_option("--map", options.map, "map in the format of ROS's map_server (YAML)")->required();
  app.add_option("--link", options.link,
                 "positions with signal, as link_mapper and tocsin map link have them; without "
                 "it the shortest way");
  app.add_option("-o,--output", options.out, "mission file to write")->required();
  app.add_option("--detour", options.most_detour,
                 "share by which the way may be longer to keep the link [0.15]")
      ->check(CLI::Range(0.0, 10.0));
}

int print_order(const OrderOptions& options) {
  std::fputs(order(options).c_str(), stdout);
  return 0;
}

int print_cover(const CoverOptions& options) {
  std::fputs(cover(options).c_str(), stdout);
  return 0;
}

}  // namespace
}  // namespace tocsin::map_tool

int main(int argc, char** argv) {
  tocsin::map_tool::Options options;
  CLI::App app("Maps: of a recorded drive, of a running system, and drives that cover one.");
  app.name("tocsin map");
  tocsin::Verbs verbs(app);
  tocsin::map_tool::declare(*verbs.add("replay", "maps a recorded drive",
                                       [&] { return tocsin::map_tool::replay_log(options); }),
                            options);
  tocsin::map_tool::CoverOptions cover;
  tocsin::map_tool::declare(*verbs.add("cover", "plans a drive that covers the floor of a map",
                                       [&] { return tocsin::map_tool::print_cover(cover); }),
                            cover);
  tocsin::map_tool::SaveOptions save;
  tocsin::map_tool::declare(*verbs.add("save", "saves the map of a running system",
                                       [&] { return tocsin::map_tool::print_save(save); }),
                            save);
  tocsin::map_tool::ContinueOptions session;
  tocsin::map_tool::declare(*verbs.add("continue", "drives and maps on from where a map was saved",
                                       [&]() -> int { tocsin::map_tool::go_on(session); }),
                            session);
  tocsin::map_tool::LinkOptions link;
  tocsin::map_tool::declare(
      *verbs.add("link", "learns where the signal is good, and how well that foretells the rest",
                 [&] { return tocsin::map_tool::print_link(link); }),
      link);
  tocsin::map_tool::OrderOptions order;
  tocsin::map_tool::declare(
      *verbs.add("order", "orders the waypoints of a mission: a short way that keeps the link",
                 [&] { return tocsin::map_tool::print_order(order); }),
      order);
  return verbs.run(argc, argv);
}
