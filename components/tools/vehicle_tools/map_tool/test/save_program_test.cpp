// SPDX-License-Identifier: Apache-2.0
// tocsin map save, on real DDS, beside a component that publishes a map; and what continue refuses.
#include <gtest/gtest.h>

#include <memory>

#include "command_line/run_to_end.hpp"
#include "foundation/temporary_folder.hpp"
#include "map_ports/map_output.hpp"
#include "navigation/map_loader.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"

namespace tocsin::map_tool {
namespace {

constexpr int domain = 163;

class Publisher final : public Component {
 public:
  explicit Publisher(Context& context) : Component(context) {
    navigation::TileMap::Tile tile(64 * 64, navigation::Cell::free);
    tile[0] = navigation::Cell::occupied;
    (void)map_.put({-1, 0}, std::move(tile));
  }
  void tick(Time now) override { map_.publish(wall(now), now); }

 private:
  MapOutput map_{*this, 0.05};
};

Ended run(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), MAP_PROGRAM);
  return run_to_end(arguments);
}

TEST(SaveProgram, SavesAMapThatWasPublishedBeforeItCame) {
  BusOptions options;
  options.name = "neighbour";
  options.host_domain = domain;
  const auto bus = make_fast_dds_bus(options);
  Context context(*bus, "map_server", Role::uxv);
  Publisher publisher(context);
  publisher.tick(bus->now());

  const TemporaryFolder folder;
  const std::vector<std::string> save{"save", folder.path("floor"), "--domain",
                                      std::to_string(domain)};
  const Ended saved = run(save);
  EXPECT_EQ(saved.code, 0) << saved.output;
  EXPECT_EQ(saved.output, "saved " + folder.path("floor") + ".yaml and " + folder.path("floor") +
                              ".pgm: 64 x 64 cells of 0.05 m\n");
  const auto map = navigation::load_map(folder.path("floor.yaml"));
  EXPECT_EQ(map.at(geometry::Point{-3.19, 0.01}), navigation::Cell::occupied);
  EXPECT_EQ(map.at(geometry::Point{-3.1, 0.01}), navigation::Cell::free);

  const Ended again = run(save);
  EXPECT_EQ(again.code, 2);
  EXPECT_NE(again.output.find("floor.yaml: is there already"), std::string::npos) << again.output;
}

TEST(SaveProgram, HasOneLineForEveryBadInput) {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::vector<std::string>, std::string>> table{
      {{"save", folder.path("m"), "--domain", "164", "--wait", "0.2"}, "no map came within 0.2 s"},
      {{"save", folder.path("m"), "--wait", "0"}, "--wait"},
      {{"save"}, "NAME"},
      {{"continue", folder.path("m")}, folder.path("m") + ".session: is not there"},
  };
  for (const auto& [arguments, error] : table) {
    const Ended ended = run(arguments);
    EXPECT_NE(ended.code, 0) << ended.output;
    EXPECT_NE(ended.output.find(error), std::string::npos) << ended.output;
  }
}

}  // namespace
}  // namespace tocsin::map_tool
