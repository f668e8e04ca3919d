// SPDX-License-Identifier: Apache-2.0
#include "vda5050_gateway/gateway.hpp"

#include <algorithm>
#include <chrono>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "navigation/mission.hpp"

namespace tocsin::vda5050 {
namespace {

/// After the end of a drive the mission's state may still be that of before.
constexpr Duration settle = std::chrono::seconds(2);
constexpr Duration retry = std::chrono::seconds(5);
constexpr Duration way_limit = std::chrono::seconds(2);
/// Without a mission for so long a drive is taken for lost: who led it was started anew.
constexpr Duration lost_after = std::chrono::seconds(5);
constexpr std::size_t most_refused = 8;
constexpr double wants_base_m = 2;
/// A drive is not replaced so near to its next node: the new one would begin with that node, which
/// the vehicle may have passed by then.
constexpr double near_m = 0.4;

constexpr double same_m = 0.01;  // two waypoints are the same

bool is_near(const Node& node, const Vehicle& vehicle) {
  return vehicle.pose && geometry::distance(geometry::position(*vehicle.pose),
                                            geometry::position(node.pose)) < near_m;
}

bool leads(const std::string& mission) {
  return mission == "waiting" || mission == "running" || mission == "paused";
}

}  // namespace

Gateway::Gateway(Params params) : params_(std::move(params)) {}

void Gateway::refuse(Fault why) {
  refused_.erase(std::remove_if(refused_.begin(), refused_.end(),
                                [&](const Fault& before) { return before.type == why.type; }),
                 refused_.end());
  if (refused_.size() == most_refused) refused_.erase(refused_.begin());
  refused_.push_back(std::move(why));
}

std::optional<Fault> Gateway::refuse_places(const Order& order) const {
  if (!params_.map) return std::nullopt;
  for (std::size_t i = 1; i < order.nodes.size(); ++i) {  // on the first one it stands
    const Node& node = order.nodes[i];
    navigation::Mission one{"order", "map", {{node.pose}}, "order"};
    try {
      require_free(one, *params_.map, params_.robot_radius_m);
    } catch (const ConfigError& error) {
      return Fault{ErrorType::no_route_to_target,
                   "node '" + printable(node.id) + "': " + error.what(),
                   {{"orderId", order.id},
                    {"orderUpdateId", std::to_string(order.update)},
                    {"nodeId", node.id}}};
    }
  }
  return std::nullopt;
}

void Gateway::on_order(const std::string& text, const Vehicle& vehicle) {
  const auto read = read_order(text, params_.identity, params_.capabilities);
  if (const auto* wrong = std::get_if<Fault>(&read)) return refuse(*wrong);
  const auto& order = std::get<Order>(read);
  if (const Mode now = mode(vehicle); now == Mode::manual || now == Mode::startup) {
    return refuse({ErrorType::mobile_robot_not_available,
                   now == Mode::manual ? "somebody else leads the vehicle"
                                       : "where the vehicle is, or its mission, is not known yet",
                   {{"orderId", order.id}}});
  }
  if (canceling_) {
    return refuse({ErrorType::other_order_active,
                   "order '" + printable(book_.id()) + "' is being canceled",
                   {{"orderId", order.id}}});
  }
  if (auto why = refuse_places(order)) return refuse(std::move(*why));
  OrderBook::Taken taken{};
  const OrderBook::Start start{vehicle.pose, params_.start_reach_m};
  if (auto why = book_.take(order, start, params_.identity.version, &taken)) {
    return refuse(std::move(*why));
  }
  if (taken == OrderBook::Taken::repetition) return;
  refused_.clear();
  invalid_action_.reset();
  blocked_.reset();
  wants_state_ = true;
}

void Gateway::on_drive(const DriveNews& news, Time now) {
  if (drive_.empty()) return;
  const auto reach = [this](std::uint32_t index) {
    for (; reached_ < std::min<std::size_t>(index, drive_.size()); ++reached_) book_.traverse();
  };
  if (news.kind == DriveNews::Kind::at) return reach(news.index);
  if (news.kind == DriveNews::Kind::succeeded) reach(UINT32_MAX);
  end_drive(news, now);
}

void Gateway::end_drive(const DriveNews& news, Time now) {
  drive_.clear();
  quiet_since_ = now;
  ended_badly_.reset();
  if (news.kind == DriveNews::Kind::unanswered) {
    try_again_ = now + retry;
  } else if (news.kind != DriveNews::Kind::succeeded && !canceling_) {
    ended_badly_ = news;
  }
}

void Gateway::resume(OrderBook book) {
  book_ = std::move(book);
  is_resuming_ = true;
}

bool Gateway::knows(const Vehicle& vehicle) const {
  return vehicle.pose && !vehicle.mission.empty() && !is_resuming_;
}

/// What was reached meanwhile counts; what is left of the leg is driven by a mission of our own.
void Gateway::go_on(const Vehicle& vehicle, Time now) {
  is_resuming_ = false;
  const auto leg = book_.leg();
  const bool is_ours =
      vehicle.mission != "paused" && !leg.empty() && !vehicle.way.empty() &&
      geometry::distance(vehicle.way.back(), geometry::position(leg.back().pose)) < same_m;
  if (!is_ours) {
    quiet_since_ = now - settle;  // who leads it now is somebody else
    return;
  }
  const std::size_t at = vehicle.mission == "done" ? vehicle.way.size() : vehicle.waypoint;
  const std::size_t left = vehicle.way.size() - std::min(at, vehicle.way.size());
  for (std::size_t nodes = leg.size(); nodes > left; --nodes) book_.traverse();
}

std::vector<Request> Gateway::update(const Vehicle& vehicle, Time now) {
  if (is_resuming_) {
    if (!vehicle.pose || vehicle.mission.empty()) {
      resume_by_ = now + way_limit;
      return {};
    }
    // The mission's way may come later than its state.
    if (leads(vehicle.mission) && vehicle.way.empty() && now < resume_by_) return {};
    led_ = quiet_since_ = now;
    go_on(vehicle, now);
  }
  follow_mode(vehicle, now);
  follow_cancel(now);
  follow_instants(vehicle, now);
  follow_node_actions(vehicle, now);
  drive_on(vehicle, now);
  return std::exchange(requests_, {});
}

/// Others lead the vehicle where a mission is under way that is no drive of ours.
void Gateway::follow_mode(const Vehicle& vehicle, Time now) {
  if (drive_.empty() || leads(vehicle.mission)) led_ = now;
  if (now - led_ > lost_after) end_drive({DriveNews::Kind::unanswered}, now);
  const bool has_settled = drive_.empty() && now - quiet_since_ >= settle;
  if (!has_settled) {
    is_foreign_ = false;
    return;
  }
  is_foreign_ = leads(vehicle.mission);
  if (is_foreign_ && !book_.is_idle()) book_.clear();
  if (!ended_badly_) return;
  if (!is_foreign_ && book_.has_base()) {
    const std::string& node = book_.nodes().front().id;
    blocked_ = Fault{ErrorType::node_unreachable,
                     "node '" + printable(node) + "': " + ended_badly_->reason,
                     {{"nodeId", node}, {"orderId", book_.id()}}};
  }
  ended_badly_.reset();
}

void Gateway::follow_cancel(Time now) {
  if (!canceling_ || !drive_.empty()) return;
  if (docking_) {
    ask(Request::Kind::cancel_dock);
    docking_.reset();
  }
  book_.clear();
  blocked_.reset();
  quiet_since_ = now;
  for (ActionState& state : instants_) {
    if (state.action.id == *canceling_) state.status = ActionStatus::finished;
  }
  canceling_.reset();
}

/// The next leg, and more of this one where the base has grown.
void Gateway::drive_on(const Vehicle& vehicle, Time now) {
  if (canceling_ || blocked_ || ended_badly_ || is_paused(vehicle) || docking_) return;
  if (book_.due() != nullptr || mode(vehicle) == Mode::manual || now < try_again_) return;
  const auto leg = book_.leg();
  if (leg.empty()) return;
  std::vector<std::uint32_t> wanted;
  std::vector<geometry::Pose> poses;
  for (const Node& node : leg) {
    wanted.push_back(node.sequence);
    poses.push_back(node.pose);
  }
  if (!drive_.empty()) {
    const std::vector<std::uint32_t> under_way(drive_.begin() + reached_, drive_.end());
    if (under_way == wanted || is_near(leg.front(), vehicle)) return;
  }
  drive_ = std::move(wanted);
  reached_ = 0;
  ask(Request::Kind::drive, std::move(poses));
}

Mode Gateway::mode(const Vehicle& vehicle) const {
  if (is_foreign_) return Mode::manual;
  if (!knows(vehicle)) return Mode::startup;
  return vehicle.driver.empty() ? Mode::automatic : Mode::intervened;
}

bool Gateway::is_paused(const Vehicle& vehicle) const {
  return pause_wanted_ || (!drive_.empty() && vehicle.mission == "paused");
}

bool Gateway::wants_base() const {
  if (!book_.has_horizon()) return false;
  double left_m = 0;
  const Node* before = nullptr;
  for (const Node& node : book_.nodes()) {
    if (!node.released) break;
    if (before != nullptr) {
      left_m += geometry::distance(geometry::position(before->pose), geometry::position(node.pose));
    }
    before = &node;
  }
  return left_m < wants_base_m;
}

std::vector<Fault> Gateway::faults(const Vehicle& vehicle) const {
  std::vector<Fault> all = refused_;
  if (invalid_action_) all.push_back(*invalid_action_);
  if (blocked_) all.push_back(*blocked_);
  if (vehicle.navigation_reason == "no_pose") {
    all.push_back({ErrorType::localization_error, "the vehicle does not know where it is"});
  }
  if (vehicle.hazard) {
    all.push_back({ErrorType::hazard_detected, "a cliff sensor or a wheel has lost the floor"});
  }
  return all;
}

}  // namespace tocsin::vda5050
