// SPDX-License-Identifier: Apache-2.0
#include "link_mapper/link_mapper_component.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

#include "foundation/read_file.hpp"
#include "geometry/pose_message.hpp"
#include "link_map/signal_file.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

constexpr std::size_t longest_file = 100'000'000;  // [byte]
constexpr Duration pose_serves = std::chrono::milliseconds(500);
constexpr Duration look = std::chrono::milliseconds(500);  // at what goes on beside

bool exists(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

/// A card that has lost its network tells no signal, which is the worst that there is.
double signal_of(const topic::NetworkQuality::Message& quality) {
  constexpr double lost_dbm = -95;
  const bool is_lost = quality.per_percent() >= 100 && quality.wireless_source() != "absent";
  return std::isnan(quality.signal_dbm()) && is_lost ? lost_dbm : quality.signal_dbm();
}

}  // namespace

LinkMapperComponent::LinkMapperComponent(Context& context, const Params& params)
    : Component(context),
      params_(params),
      keeps_files_(context.computer.get().keeps_files),
      worker_(context.computer.get().open_background()) {
  if (params_.map_name.empty() || !exists(file())) return;
  for (const auto& reading : link_map::signals_in(read_file(file(), longest_file), file(), "")) {
    if (survey_.add(reading)) ++unlearned_;
  }
}

LinkMapperComponent::~LinkMapperComponent() {
  if (keeps() && unsaved_ > 0) worker_.save(file(), survey_.readings());
}

void LinkMapperComponent::tick(Time now) {
  take_pose(now);
  take_quality(now);
  learn(now);
  publish(now);
  save(now);
  wake_at(now + look);
}

void LinkMapperComponent::take_pose(Time now) {
  const auto message = pose_in_.take_latest();
  if (!message) return;
  const auto& covariance = message->pose().covariance();
  const double deviation_m = std::sqrt(std::max(covariance[0], covariance[7]));
  const geometry::Point at = position(geometry::pose_in(message->pose().pose()));
  at_.reset();
  if (!is_finite(at) || !(deviation_m <= params_.most_deviation_m)) return;
  at_ = at;
  at_since_ = now;
}

void LinkMapperComponent::take_quality(Time now) {
  while (const auto quality = quality_.take()) {
    if (!at_ || now - at_since_ > pose_serves) continue;
    if (!survey_.add({*at_, signal_of(*quality), quality->per_percent() / 100.0})) continue;
    ++unlearned_;
    ++unsaved_;
  }
}

void LinkMapperComponent::learn(Time now) {
  const bool is_due = now >= next_learn_ && unlearned_ > 0 && !worker_.is_busy();
  if (!is_due || survey_.size() < link_map::LinkMap::least_places) return;
  next_learn_ = next_instant(seconds(params_.learn_every_s), now);
  unlearned_ = 0;
  worker_.learn(survey_);
}

nav_msgs::msg::OccupancyGrid LinkMapperComponent::message_of(const link_map::LinkGrid& grid,
                                                             Time now) const {
  nav_msgs::msg::OccupancyGrid message;
  message.header().stamp(wall(now));
  message.header().frame_id("map");
  message.info().map_load_time(wall(now));
  message.info().resolution(static_cast<float>(link_map::LinkGrid::cell_m));
  message.info().width(static_cast<std::uint32_t>(grid.width));
  message.info().height(static_cast<std::uint32_t>(grid.height));
  message.info().origin().position().x(grid.origin.x_m);
  message.info().origin().position().y(grid.origin.y_m);
  message.info().origin().orientation().w(1);
  return message;
}

void LinkMapperComponent::publish(Time now) {
  auto grid = worker_.take_grid();
  if (!grid) return;
  auto message = message_of(*grid, now);
  message.data(std::move(grid->risk));
  if (risk_.write(message) == Status::failed) log().warn("no risk of the link was told");
  message.data(std::move(grid->cells));
  if (map_.write(std::move(message)) == Status::failed) log().warn("no map of the link was sent");
}

void LinkMapperComponent::save(Time now) {
  if (const auto error = worker_.take_error()) {
    log().warn("{} cannot be written: {}", file(), *error);
    ++unsaved_;
  }
  if (!keeps() || unsaved_ == 0 || now < next_save_ || worker_.is_busy()) return;
  next_save_ = now + seconds(params_.save_every_s);
  unsaved_ = 0;
  worker_.save(file(), survey_.readings());
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::LinkMapperComponent)
