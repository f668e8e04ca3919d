// SPDX-License-Identifier: Apache-2.0
#include "vda5050_gateway/vda5050_gateway_component.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/read_file.hpp"
#include "foundation/replace_file.hpp"
#include "geometry/pose_message.hpp"
#include "navigation/map_loader.hpp"
#include "runtime/component_entry.hpp"

namespace tocsin {
namespace {

using std::chrono::hours;

constexpr double rate_hz = 10;
constexpr Duration answer_limit = std::chrono::seconds(5);
constexpr std::size_t longest_order = 4 * vda5050::most_message_bytes;
constexpr Duration result_limit = hours(24 * 365);
/// Of a pose that somebody tells, as rviz2 has it: 0.5 m and 15 degrees.
constexpr double told_variance_m2 = 0.25;
constexpr double told_variance_rad2 = 0.0685;

/// Throws ConfigError.
std::string level(const char* name, const std::string& text) {
  const auto is_fine = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string("_.:-").find(c) != std::string::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), is_fine)) return text;
  throw ConfigError(std::string(name) + ": '" + printable(text) +
                    "' must be of A-Z, a-z, 0-9, '_', '.', ':' and '-'");
}

vda5050::Identity identity_of(const Vda5050GatewayComponent::Params& params) {
  return {params.version,
          params.interface_name.empty() ? "" : level("interface_name", params.interface_name),
          level("manufacturer", params.manufacturer), level("serial_number", params.serial_number)};
}

vda5050::Gateway::Params gateway_of(const Vda5050GatewayComponent::Params& params) {
  vda5050::Gateway::Params made;
  made.identity = identity_of(params);
  made.capabilities = params.capabilities;
  made.start_reach_m = params.start_reach_m;
  if (!params.map_file.empty()) made.map = navigation::load_map(params.map_file);
  made.robot_radius_m = params.robot_radius_m;
  return made;
}

vda5050::BrokerAddress address_of(const Vda5050GatewayComponent::Params& params) {
  vda5050::BrokerAddress address = params.broker;
  address.port = static_cast<std::uint16_t>(params.port);
  address.client_id = params.manufacturer + "-" + params.serial_number;
  return address;
}

vda5050::DriveNews news_of(const ActionClient<action::FollowWaypoints>::News& news) {
  using What = ActionClient<action::FollowWaypoints>::What;
  using Kind = vda5050::DriveNews::Kind;
  const std::string reason = news.result ? printable(news.result->error_msg()) : "";
  switch (news.what) {
    case What::accepted:
    case What::canceling:
      return {Kind::at, 0};
    case What::feedback:
      return {Kind::at, news.feedback->current_waypoint()};
    case What::rejected:
      return {Kind::rejected, 0, reason};
    case What::not_ended:
      return {Kind::aborted, 0, "nobody knows of it"};
    case What::unanswered:
      return {Kind::unanswered};
    case What::result:
      break;
  }
  if (news.state == GoalState::succeeded) return {Kind::succeeded};
  return {news.state == GoalState::canceled ? Kind::canceled : Kind::aborted, 0, reason};
}

}  // namespace

Vda5050GatewayComponent::Vda5050GatewayComponent(Context& context, const Params& params,
                                                 const vda5050::Connect& connect)
    : Component(context),
      gateway_(gateway_of(params)),
      publications_(identity_of(params), params.publications),
      address_(address_of(params)),
      connect_(connect),
      file_(context.state_path(".order")) {
  vda5050::check_files(address_);
  load();
  wake_every(seconds(1 / rate_hz));
}

/// At the first tick: whoever only looks at a deployment connects to nobody.
bool Vda5050GatewayComponent::connects(Time now) {
  if (broker_) return true;
  if (!context().computer.get().has_spectators) return false;
  const vda5050::Identity& identity = gateway_.identity();
  broker_ = connect_(address_, publications_.will(wall_ns(now)),
                     {identity.topic("order"), identity.topic("instantActions")});
  return true;
}

Vda5050GatewayComponent::~Vda5050GatewayComponent() {
  if (broker_) broker_->publish(publications_.farewell(wall_ns(bus().now())));
}

void Vda5050GatewayComponent::tick(Time now) {
  if (!connects(now)) return;
  take_inputs();
  take_reports();
  if (const auto link = link_.take_latest()) {
    heard_.reset();
    if (std::isfinite(link->silence_s())) heard_ = now - seconds(link->silence_s());
  }
  vehicle_.silence_s = heard_ ? to_seconds(now - *heard_) : infinity;
  take_drive(now);
  take_broker(now);
  for (const vda5050::Request& request : gateway_.update(vehicle_, now)) obey(request, now);
  save();
  publish(now);
}

/// Only of this launch: later the vehicle stands, and fleet control knows better.
void Vda5050GatewayComponent::load() {
  if (file_.empty() || !std::filesystem::exists(file_)) return;
  const auto saved = nlohmann::json::parse(read_file(file_, longest_order), nullptr, false);
  const bool is_ours = saved.is_object() && saved.value("parent", 0) == ::getppid();
  auto book =
      is_ours ? vda5050::OrderBook::restore(saved.value("order", nlohmann::json())) : std::nullopt;
  if (book) gateway_.resume(std::move(*book));
}

/// What fleet control is told of an order is kept before it is told.
void Vda5050GatewayComponent::save() {
  if (file_.empty()) return;
  const nlohmann::json kept = {{"parent", ::getppid()}, {"order", gateway_.order().save()}};
  std::string text = kept.dump();
  if (text == saved_) return;
  if (const auto error = replace_file(file_, text, Sync::no)) {
    log().warn("{}: {}", file_, error.message());
  }
  saved_ = std::move(text);
}

void Vda5050GatewayComponent::take_inputs() {
  if (const auto location = location_.take_latest()) {
    const geometry::Pose pose = geometry::pose_in(location->pose().pose());
    if (is_finite(pose)) vehicle_.pose = pose;
    const double variance =
        std::max(location->pose().covariance()[0], location->pose().covariance()[7]);
    vehicle_.deviation_m = variance > 0 && std::isfinite(variance) ? 2 * std::sqrt(variance) : 0;
  }
  if (const auto status = navigation_.take_latest()) {
    vehicle_.navigation = status->state();
    vehicle_.navigation_reason = status->reason();
  }
  if (const auto mission = mission_.take_latest()) {
    vehicle_.mission = mission->state();
    vehicle_.waypoint = mission->waypoint();
  }
  if (const auto way = way_.take_latest()) {
    vehicle_.way.clear();
    for (const auto& stamped : way->poses()) {
      vehicle_.way.push_back(geometry::position(geometry::pose_in(stamped.pose())));
    }
  }
  if (const auto driver = driver_.take_latest()) vehicle_.driver = driver->driver();
  if (const auto docking = docking_.take_latest()) {
    vehicle_.docking_run = docking->run();
    vehicle_.docking = docking->state();
    vehicle_.docking_result = docking->result();
  }
}

void Vda5050GatewayComponent::take_reports() {
  if (const auto battery = battery_.take_latest()) {
    using namespace sensor_msgs::msg::BatteryState_Constants;
    const double charge = 100.0 * static_cast<double>(battery->percentage());
    vehicle_.charge_percent = std::isfinite(charge) ? std::clamp(charge, 0.0, 100.0) : 0;
    vehicle_.voltage_v.reset();
    if (std::isfinite(battery->voltage())) vehicle_.voltage_v = battery->voltage();
    vehicle_.is_charging = battery->power_supply_status() == POWER_SUPPLY_STATUS_CHARGING ||
                           battery->power_supply_status() == POWER_SUPPLY_STATUS_FULL;
  }
  if (const auto safety = safety_.take_latest()) {
    vehicle_.emergency_stop = safety->emergency_stop();
    const auto& by = safety->stopped_by();
    vehicle_.stopped_by_station =
        std::find(by.begin(), by.end(), topic::EmergencyStop::station_name) != by.end();
    vehicle_.bumper = safety->bumper() != 0;
    vehicle_.hazard = safety->cliff() != 0 || safety->wheel_drop() != 0;
  }
  while (const auto state = transmission_.take()) {
    if (state->role() != to_string(Role::uxv)) continue;
    vehicle_.qni_percent.reset();
    if (std::isfinite(state->qni())) vehicle_.qni_percent = state->qni();
  }
}

void Vda5050GatewayComponent::take_drive(Time now) {
  while (const auto news = drive_.take(now)) {
    if (goal_ && news->id == *goal_) gateway_.on_drive(news_of(*news), now);
  }
}

void Vda5050GatewayComponent::take_broker(Time now) {
  if (const std::string trouble = broker_->trouble(); trouble != trouble_) {
    trouble_ = trouble;
    if (!trouble.empty()) log().warn("MQTT broker: {}", printable(trouble));
  }
  if (const auto connections = broker_->connections(); connections != connections_) {
    connections_ = connections;
    publications_.on_connected();
    log().info("MQTT broker: connected");
  }
  while (const auto message = broker_->take()) {
    if (message->topic == gateway_.identity().topic("order")) {
      gateway_.on_order(message->payload, vehicle_);
    } else {
      gateway_.on_instant_actions(message->payload, vehicle_, now);
    }
  }
}

template <class Topic>
void Vda5050GatewayComponent::send(Output<Topic>& output, typename Topic::Message message) {
  if (output.write(std::move(message)) == Status::ok) return;
  log().warn("{} was not sent", Topic::info.name);
}

template <class Topic>
void Vda5050GatewayComponent::say(Output<Topic>& output, const char* word) {
  typename Topic::Message message;
  message.data(word);
  send(output, std::move(message));
}

void Vda5050GatewayComponent::obey(const vda5050::Request& request, Time now) {
  using Kind = vda5050::Request::Kind;
  switch (request.kind) {
    case Kind::drive:
      return drive(request, now);
    case Kind::cancel_drive:
      if (goal_) drive_.cancel(*goal_, now + answer_limit);
      return;
    case Kind::pause:
      return say(mission_command_, "pause");
    case Kind::resume:
      return say(mission_command_, "resume");
    case Kind::dock:
      return say(docking_command_, "start");
    case Kind::cancel_dock:
      return say(docking_command_, "cancel");
    case Kind::set_pose:
      return set_pose(request.poses.front(), now);
  }
}

void Vda5050GatewayComponent::set_pose(const geometry::Pose& pose, Time now) {
  topic::InitialPose::Message told;
  told.header().stamp(wall(now));
  told.header().frame_id("map");
  told.pose().pose(geometry::pose_message<geometry_msgs::msg::Pose>(pose));
  told.pose().covariance()[0] = told.pose().covariance()[7] = told_variance_m2;
  told.pose().covariance()[35] = told_variance_rad2;
  send(initial_pose_, std::move(told));
}

void Vda5050GatewayComponent::drive(const vda5050::Request& request, Time now) {
  action::FollowWaypoints::Goal goal;
  for (const geometry::Pose& pose : request.poses) {
    geometry_msgs::msg::PoseStamped place;
    place.header().frame_id("map");
    place.pose(geometry::pose_message<geometry_msgs::msg::Pose>(pose));
    goal.poses().push_back(std::move(place));
  }
  log().info("order {}, update {}: drives to {} nodes", printable(gateway_.order().id()),
             gateway_.order().update(), request.poses.size());
  goal_ = drive_.send(std::move(goal), now + answer_limit, now + result_limit);
}

void Vda5050GatewayComponent::publish(Time now) {
  if (!broker_->is_connected()) return;
  for (const vda5050::Message& message : publications_.due(gateway_, vehicle_, now, wall_ns(now))) {
    if (!broker_->publish(message)) log().warn("{} was not published", message.topic);
  }
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::Vda5050GatewayComponent)
