// SPDX-License-Identifier: Apache-2.0
// Instant actions, and actions on nodes.
#include <algorithm>
#include <chrono>
#include <cmath>

#include "foundation/printable.hpp"
#include "vda5050_gateway/gateway.hpp"

namespace tocsin::vda5050 {
namespace {

constexpr Duration pose_limit = std::chrono::seconds(10);      // for a pose to be the vehicle's
constexpr Duration docking_repeat = std::chrono::seconds(3);   // while the vehicle does not begin
constexpr Duration docking_limit = std::chrono::seconds(180);  // above the vehicle's own
constexpr Duration pause_repeat = std::chrono::seconds(1);     // until the mission has it
constexpr double same_pose_m = 0.5;

/// Of initPosition (2.1) and initializePosition (3.0); nothing: a parameter is missing or too
/// large.
std::optional<geometry::Pose> pose_in(const Action& action) {
  const auto x = action.number("x");
  const auto y = action.number("y");
  const auto theta = action.number("theta");
  if (!x || !y || !theta || std::abs(*x) > farthest_m || std::abs(*y) > farthest_m) {
    return std::nullopt;
  }
  return geometry::Pose{*x, *y, geometry::wrap_angle(*theta)};
}

}  // namespace

void Gateway::on_instant_actions(const std::string& text, const Vehicle& vehicle, Time now) {
  const auto read = read_instant_actions(text, params_.identity);
  if (const auto* wrong = std::get_if<Fault>(&read)) return refuse(*wrong);
  for (const Action& action : std::get<std::vector<Action>>(read)) {
    begin_instant(action, vehicle, now);
  }
}

void Gateway::fail_instant(ActionState& state, std::string why) {
  state.status = ActionStatus::failed;
  state.result = why;
  invalid_action_ =
      Fault{ErrorType::invalid_instant_action, std::move(why), {{"actionId", state.action.id}}};
}

void Gateway::begin_instant(const Action& action, const Vehicle& vehicle, Time now) {
  const bool is_known =
      std::any_of(instants_.begin(), instants_.end(),
                  [&](const ActionState& state) { return state.action.id == action.id; });
  if (is_known) return;  // sent again
  make_room(action);
  if (instants_.size() >= most_instant_actions) {
    invalid_action_ = Fault{ErrorType::instant_action_states_full,
                            "clearInstantActions first",
                            {{"actionId", action.id}}};
    return;
  }
  instants_.push_back({action, ActionStatus::running});
  invalid_action_.reset();
  wants_state_ = true;
  begin(instants_.back(), vehicle, now);
}

/// Of what has ended: when fleet control says so; 2.1 has no word for it.
void Gateway::make_room(const Action& action) {
  const bool is_asked = is_new() && action.type == "clearInstantActions";
  if (!is_asked && (is_new() || instants_.size() < most_instant_actions)) return;
  instants_.erase(std::remove_if(instants_.begin(), instants_.end(), has_ended), instants_.end());
}

void Gateway::begin(ActionState& state, const Vehicle& vehicle, Time now) {
  const std::string& type = state.action.type;
  if (type == "cancelOrder") return begin_cancel(state);
  if (type == "startPause" || type == "stopPause") {
    pause_wanted_ = type == "startPause";
    was_paused_ = false;
    pause_asked_ = Time{};
    return;
  }
  const bool sets_pose = type == (is_new() ? "initializePosition" : "initPosition");
  if (sets_pose || type == "startCharging") {
    const Mode who = mode(vehicle);  // a position may be what it waits for
    if (who != Mode::automatic && !(sets_pose && who == Mode::startup)) {
      return fail_instant(state, "fleet control is not in control");
    }
    return sets_pose ? begin_pose(state, now) : begin_docking(state, vehicle, now);
  }
  state.status = ActionStatus::finished;
  if (type == "factsheetRequest") {
    wants_factsheet_ = true;
  } else if (type != "stateRequest" && !(is_new() && type == "clearInstantActions")) {
    fail_instant(state, "'" + printable(type) + "' is not an instant action of this vehicle");
  }
}

void Gateway::begin_cancel(ActionState& state) {
  const auto order = state.action.text("orderId");
  if (book_.is_idle() || canceling_ || (order && *order != book_.id())) {
    state.status = ActionStatus::failed;
    refuse({ErrorType::no_order_to_cancel,
            canceling_ ? "the order is being canceled" : "there is no such order",
            {{"actionId", state.action.id}}});
    return;
  }
  canceling_ = state.action.id;
  if (!drive_.empty()) ask(Request::Kind::cancel_drive);
}

void Gateway::begin_pose(ActionState& state, Time now) {
  const auto pose = pose_in(state.action);
  if (!pose)
    return fail_instant(state, "parameters x and y must be numbers within 1000 km, theta a number");
  if (const auto map = state.action.text("mapId"); map && *map != params_.capabilities.map_id) {
    return fail_instant(
        state, "mapId is '" + printable(*map) + "', not '" + params_.capabilities.map_id + "'");
  }
  if (!drive_.empty()) return fail_instant(state, "the vehicle drives");
  pose_asked_ = now;
  ask(Request::Kind::set_pose, {*pose});
}

void Gateway::follow_pose(ActionState& state, const Vehicle& vehicle, Time now) {
  const auto wanted = pose_in(state.action);
  if (!pose_asked_ || !wanted) return;
  const bool is_there =
      vehicle.pose && geometry::distance(geometry::position(*vehicle.pose),
                                         geometry::position(*wanted)) < same_pose_m;
  if (is_there) {
    state.status = ActionStatus::finished;
    if (const auto node = state.action.text("lastNodeId")) book_.stand_on(printable(*node));
  } else if (now - *pose_asked_ > pose_limit) {
    fail_instant(state, "the vehicle does not take the position");
  }
}

void Gateway::follow_instants(const Vehicle& vehicle, Time now) {
  for (ActionState& state : instants_) {
    if (state.status != ActionStatus::running) continue;
    const std::string& type = state.action.type;
    if (type == "startCharging") {
      follow_docking(state, vehicle, now);
    } else if (type == "initPosition" || type == "initializePosition") {
      follow_pose(state, vehicle, now);
    } else if (type == "startPause" || type == "stopPause") {
      follow_pause(state, vehicle, now);
    }
  }
  if (!pause_wanted_ || drive_.empty()) return;
  // Somebody at the station may have the mission go on.
  if (was_paused_ && vehicle.mission == "running") pause_wanted_ = false;
  was_paused_ = vehicle.mission == "paused";
}

void Gateway::follow_pause(ActionState& state, const Vehicle& vehicle, Time now) {
  const bool wants_pause = state.action.type == "startPause";
  const bool is_overtaken = wants_pause != pause_wanted_;
  if (is_overtaken || drive_.empty() || (vehicle.mission == "paused") == wants_pause) {
    state.status = ActionStatus::finished;
  } else if (pause_asked_ == Time{} || now - pause_asked_ >= pause_repeat) {
    pause_asked_ = now;
    ask(wants_pause ? Request::Kind::pause : Request::Kind::resume);
  }
}

void Gateway::follow_node_actions(const Vehicle& vehicle, Time now) {
  if (canceling_ || pause_wanted_) return;
  ActionState* due = book_.due();
  if (due == nullptr || !drive_.empty()) return;
  if (due->status == ActionStatus::waiting) begin_docking(*due, vehicle, now);
  if (due->status == ActionStatus::running) follow_docking(*due, vehicle, now);
}

void Gateway::begin_docking(ActionState& state, const Vehicle& vehicle, Time now) {
  if (!drive_.empty() || docking_) {
    return fail_instant(state, docking_ ? "the vehicle docks already" : "the vehicle drives");
  }
  state.status = ActionStatus::running;
  if (vehicle.is_charging) {
    state.status = ActionStatus::finished;
    return;
  }
  docking_ = Docking{state.action.id, vehicle.docking_run, now, now};
  ask(Request::Kind::dock);
}

void Gateway::follow_docking(ActionState& state, const Vehicle& vehicle, Time now) {
  if (!docking_ || docking_->action != state.action.id) return;
  const bool has_begun = vehicle.docking_run != docking_->run_before;
  const bool is_over = has_begun && vehicle.docking == "done";
  if (!is_over && now - docking_->since < docking_limit) {
    if (has_begun || now - docking_->asked < docking_repeat) return;
    docking_->asked = now;
    return ask(Request::Kind::dock);
  }
  docking_.reset();
  state.result = is_over ? vehicle.docking_result : "the vehicle does not answer";
  state.status = state.result == "docked" ? ActionStatus::finished : ActionStatus::failed;
}

}  // namespace tocsin::vda5050
