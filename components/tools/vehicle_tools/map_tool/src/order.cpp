// SPDX-License-Identifier: Apache-2.0
#include "order.hpp"

#include <fmt/format.h>

#include <memory>
#include <numeric>
#include <optional>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/read_file.hpp"
#include "link_map/link_grid.hpp"
#include "link_map/signal_file.hpp"
#include "navigation/link_risk.hpp"
#include "navigation/map_loader.hpp"
#include "navigation/mission.hpp"
#include "navigation/mission_writer.hpp"
#include "navigation/planner.hpp"
#include "navigation/waypoint_order.hpp"

namespace tocsin::map_tool {
namespace {

using navigation::Leg;
using navigation::Mission;

constexpr std::size_t most_ordered = 100;
constexpr std::size_t longest_link = 100'000'000;  // [byte]

std::optional<navigation::LinkRisk> read_link(const std::string& path) {
  if (path.empty()) return std::nullopt;
  link_map::Survey survey;
  for (const link_map::Reading& reading :
       link_map::signals_in(read_file(path, longest_link), printable(path), "")) {
    (void)survey.add(reading);
  }
  if (survey.size() < link_map::LinkMap::least_places) {
    throw ConfigError(fmt::format("{}: has {} places with signal; at least {} are needed",
                                  printable(path), survey.size(), link_map::LinkMap::least_places));
  }
  const link_map::LinkGrid grid = grid_of(survey);
  return navigation::LinkRisk({grid.width, grid.height, link_map::LinkGrid::cell_m, grid.origin},
                              grid.risk);
}

navigation::Legs legs_of(const Mission& mission, navigation::Planner& planner,
                         const std::optional<navigation::LinkRisk>& risk) {
  const std::size_t count = mission.waypoints.size();
  navigation::Legs legs(count, std::vector<Leg>(count, Leg{0, 0}));
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = i + 1; k < count; ++k) {
      const auto path =
          planner.plan(position(mission.waypoints[i]), position(mission.waypoints[k]));
      if (!path) {
        throw ConfigError(fmt::format("{}: there is no way between waypoints {} and {}",
                                      mission.file, i + 1, k + 1));
      }
      legs[i][k] = {navigation::length_m(*path), risk ? risk->silent_m(*path) : 0};
      legs[k][i] = legs[i][k];
    }
  }
  return legs;
}

std::string text_of(const Leg& before, const Leg& after) {
  return fmt::format("way {:.1f} -> {:.1f} m, {:.1f} -> {:.1f} m of it without link\n",
                     before.length_m, after.length_m, before.silent_m, after.silent_m);
}

}  // namespace

std::string order(const OrderOptions& options) {
  const Mission mission = navigation::load_mission(options.mission);
  if (mission.waypoints.size() > most_ordered) {
    throw ConfigError(fmt::format("{}: {} waypoints are more than {}", printable(options.mission),
                                  mission.waypoints.size(), most_ordered));
  }
  const auto risk = read_link(options.link);
  const auto map = navigation::load_map(options.map);
  const navigation::InflationParams inflation;
  require_free(mission, map, inflation.robot_radius_m);
  navigation::Planner planner(std::make_shared<const navigation::CostMap>(map, inflation));
  const auto legs = legs_of(mission, planner, risk);

  std::vector<std::size_t> given(mission.waypoints.size());
  std::iota(given.begin(), given.end(), 0U);
  const auto before = navigation::along(legs, given);
  const auto after = navigation::ordered(legs, options.most_detour);
  Mission other = mission;
  other.waypoints.clear();
  for (const std::size_t place : after.places) {
    other.waypoints.push_back(mission.waypoints[place]);
  }
  navigation::write_mission(other, options.out);
  return text_of(before.way, after.way);
}

}  // namespace tocsin::map_tool
