// SPDX-License-Identifier: Apache-2.0
#include "localiser/localiser_component.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "foundation/enum_words.hpp"
#include "foundation/error.hpp"
#include "geometry/pose_message.hpp"
#include "navigation/map_loader.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

using localisation::Health;
using localisation::Localiser;

constexpr Duration second = std::chrono::seconds(1);
constexpr double start_deviation_m = 0.3;
constexpr double start_deviation_rad = 0.2;

navigation::OccupancyMap map_of(const std::string& name, const std::string& file) {
  if (file.empty()) throw ConfigError(name + ".map_file: is required");
  navigation::OccupancyMap map = navigation::load_map(file);
  const auto& cells = map.cells();
  if (std::find(cells.begin(), cells.end(), navigation::Cell::free) == cells.end()) {
    throw ConfigError(file + ": no cell of the map is free");
  }
  return map;
}

/// What another process of the same launch has kept.
std::optional<geometry::Pose> kept_in(const StateFile& file) {
  std::istringstream text(file.load().value_or(""));
  pid_t parent = 0;
  geometry::Pose pose;
  text >> parent >> pose.x_m >> pose.y_m >> pose.heading_rad;
  const bool is_ours = text && parent == ::getppid() && is_finite(pose);
  return is_ours ? std::optional(pose) : std::nullopt;
}

diagnostic_msgs::msg::KeyValue value(const char* key, std::string text) {
  diagnostic_msgs::msg::KeyValue pair;
  pair.key(key);
  pair.value(std::move(text));
  return pair;
}

}  // namespace

LocaliserComponent::LocaliserComponent(Context& context, const Params& params)
    : Component(context),
      params_(params),
      localiser_(map_of(context.name, params.map_file), params.localiser),
      file_(context.state_path(".pose")) {
  const auto kept = kept_in(file_);
  is_restarted_ = kept.has_value();
  map_from_odom_ =
      kept.value_or(geometry::Pose{params.start_x_m, params.start_y_m, params.start_yaw_rad});
}

void LocaliserComponent::tick(Time now) {
  take_odometry();
  take_orders();
  take_scan(now);
  publish_diagnostics(now);
  remember(now);
  wake_at(next_diagnostics_);
}

void LocaliserComponent::take_odometry() {
  while (const auto odom = odom_.take()) {
    const geometry::Pose pose = geometry::pose_in(odom->pose().pose());
    if (!is_finite(pose)) continue;
    odometry_.add(stamp_ns_of(odom->header()), pose);
    const auto& twist = odom->twist().twist();
    velocity_ = {twist.linear().x(), twist.angular().z()};
    last_odom_ = pose;
  }
}

void LocaliserComponent::take_orders() {
  while (const auto pose = initial_pose_.take()) take_initial_pose(*pose);
  while (const auto call = reinitialize_.take()) {
    localiser_.start_anywhere();
    has_begun_ = true;
    log().info("looks for the vehicle everywhere");
    reinitialize_.reply(call->id, {});
  }
  while (const auto call = set_initial_pose_.take()) {
    take_initial_pose(call->request->pose());
    set_initial_pose_.reply(call->id, {});
  }
  while (const auto call = nomotion_.take()) {
    localiser_.count_next();
    nomotion_.reply(call->id, {});
  }
}

/// A person means it to about half a metre and a tenth of a turn, whatever the covariance says.
void LocaliserComponent::take_initial_pose(const topic::InitialPose::Message& message) {
  constexpr double person_m = 0.5;
  constexpr double person_rad = 0.5;
  const geometry::Pose pose = geometry::pose_in(message.pose().pose());
  const std::string& frame = message.header().frame_id();
  if (!is_finite(pose) || (frame != "map" && !frame.empty())) {
    log().warn("an initial pose is refused: it is not finite, or its frame is not map");
    return;
  }
  localiser_.start_at(pose, person_m, person_rad);
  has_begun_ = true;
  log().info("a person says that it is at ({:.2f}, {:.2f})", pose.x_m, pose.y_m);
}

void LocaliserComponent::begin(const geometry::Pose& odom) {
  has_begun_ = true;
  if (params_.start_anywhere && !is_restarted_) return localiser_.start_anywhere();
  localiser_.start_at(compose(map_from_odom_, odom), start_deviation_m, start_deviation_rad);
}

void LocaliserComponent::take_scan(Time now) {
  const auto turn = scan_.take(odometry_, velocity_);
  if (!turn) return;
  const auto odom = odometry_.at(turn->stamp_ns);
  if (!odom) return;
  if (!has_begun_) begin(*odom);
  const auto estimate = localiser_.update(turn->scan, *odom);
  if (!estimate) return;
  estimate_ = *estimate;
  if (estimate->health == Health::tracked) {
    map_from_odom_ = compose(estimate->belief.pose, inverse(*odom));
  }
  const builtin_interfaces::msg::Time stamp = stamp_of(turn->stamp_ns);
  publish(*estimate, stamp);
  publish_cloud(stamp, now);
  if (told_ == estimate->health) return;
  told_ = estimate->health;
  log().info("{}: {:.0f} % of the scan is on the map", word_of(*told_), 100 * estimate->explained);
}

void LocaliserComponent::publish(const Localiser::Estimate& estimate,
                                 const builtin_interfaces::msg::Time& stamp) {
  const Eigen::Matrix3d& c = estimate.belief.covariance;
  pose_.publish_pose(
      estimate.belief.pose,
      {c(0, 0), c(0, 1), c(0, 2), c(1, 0), c(1, 1), c(1, 2), c(2, 0), c(2, 1), c(2, 2)}, stamp);
  if (estimate.health == Health::tracked) pose_.publish_transform(map_from_odom_, stamp);
}

void LocaliserComponent::publish_cloud(const builtin_interfaces::msg::Time& stamp, Time now) {
  if (now < next_cloud_ || !cloud_.wanted()) return;
  next_cloud_ = now + second;
  topic::ParticleCloud::Message message;
  message.header().stamp(stamp);
  message.header().frame_id("map");
  for (const Localiser::Hypothesis& hypothesis : localiser_.hypotheses()) {
    nav2_msgs::msg::Particle particle;
    particle.pose(geometry::pose_message<geometry_msgs::msg::Pose>(hypothesis.belief.pose));
    particle.weight(hypothesis.weight);
    message.particles().push_back(particle);
  }
  if (cloud_.write(std::move(message)) == Status::failed) log().warn("no cloud was sent");
}

void LocaliserComponent::publish_diagnostics(Time now) {
  if (now < next_diagnostics_) return;
  next_diagnostics_ = next_instant(second, now);
  if (!diagnostics_.wanted()) return;
  const char* const words = told_ ? word_of(*told_) : "waiting for scans and odometry";
  diagnostic_msgs::msg::DiagnosticStatus status;
  status.level(told_ == Health::tracked ? 0 : told_ == Health::lost ? 2 : 1);
  status.name(name() + ": pose");
  status.message(words);
  status.values({value("explained", fmt::format("{:.2f}", estimate_.explained)),
                 value("hypotheses", std::to_string(localiser_.hypotheses().size()))});
  topic::Diagnostics::Message message;
  message.header().stamp(wall(now));
  message.status().push_back(status);
  if (diagnostics_.write(std::move(message)) == Status::failed) log().warn("no diagnostics sent");
}

void LocaliserComponent::remember(Time now) {
  if (!file_.keeps() || told_ != Health::tracked || now < next_save_) return;
  next_save_ = now + second;
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << ::getppid() << ' ' << map_from_odom_.x_m << ' ' << map_from_odom_.y_m << ' '
       << map_from_odom_.heading_rad;
  if (!file_.save(text.str())) log().warn("the pose cannot be saved for a restart");
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::LocaliserComponent)
