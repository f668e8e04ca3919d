// SPDX-License-Identifier: Apache-2.0
#include "vda5050_gateway/messages.hpp"

#include "foundation/enum_words.hpp"
#include "foundation/printable.hpp"

namespace tocsin::vda5050 {
namespace {

using nlohmann::json;

bool is_new(const Gateway& gateway) { return gateway.identity().version == Version::v3_0; }

json nodes_in(const OrderBook& order, const Capabilities& vehicle) {
  json all = json::array();
  for (const Node& node : order.nodes()) {
    all.push_back({{"nodeId", node.id},
                   {"sequenceId", node.sequence},
                   {"released", node.released},
                   {"nodePosition",
                    {{"x", node.pose.x_m},
                     {"y", node.pose.y_m},
                     {"theta", geometry::wrap_angle(node.pose.heading_rad)},
                     {"mapId", vehicle.map_id}}}});
  }
  return all;
}

json edges_in(const OrderBook& order) {
  json all = json::array();
  for (const Edge& edge : order.edges()) {
    all.push_back(
        {{"edgeId", edge.id}, {"sequenceId", edge.sequence}, {"released", edge.released}});
  }
  return all;
}

void add_actions(json& all, const std::vector<ActionState>& states, Version version) {
  for (const ActionState& state : states) {
    json one = {{"actionId", state.action.id},
                {"actionType", state.action.type},
                {"actionStatus", word_of(state.status)}};
    if (!state.result.empty()) {
      one[version == Version::v3_0 ? "actionResult" : "resultDescription"] =
          printable(state.result);
    }
    all.push_back(std::move(one));
  }
}

json references(const std::vector<std::pair<std::string, std::string>>& all) {
  json made = json::array();
  for (const auto& [key, value] : all) {
    made.push_back({{"referenceKey", key}, {"referenceValue", value}});
  }
  return made;
}

json errors_in(const Gateway& gateway, const Vehicle& vehicle) {
  const Version version = gateway.identity().version;
  json all = json::array();
  for (const Fault& fault : gateway.faults(vehicle)) {
    all.push_back({{"errorType", error_name(fault.type, version)},
                   {"errorLevel", error_level(fault.type, version)},
                   {"errorDescription", fault.description},
                   {"errorReferences", references(fault.references)}});
  }
  return all;
}

/// Figures of the radio link, which fleet managers have no field for.
json information_in(const Gateway& gateway, const Vehicle& vehicle) {
  std::vector<std::pair<std::string, std::string>> figures;
  figures.emplace_back("silence_s", fixed_text(vehicle.silence_s, 1));
  if (vehicle.qni_percent) figures.emplace_back("qni_percent", fixed_text(*vehicle.qni_percent, 0));
  const char* description = is_new(gateway) ? "infoDescriptor" : "infoDescription";
  return json::array({{{"infoType", "radio_link"},
                       {"infoLevel", "INFO"},
                       {description, "seconds since the vehicle was heard; quality of its link"},
                       {"infoReferences", references(figures)}}});
}

json position_in(const Gateway& gateway, const Vehicle& vehicle) {
  return {{"x", vehicle.pose->x_m},
          {"y", vehicle.pose->y_m},
          {"theta", geometry::wrap_angle(vehicle.pose->heading_rad)},
          {"mapId", gateway.capabilities().map_id},
          {"deviationRange", vehicle.deviation_m},
          {is_new(gateway) ? "localized" : "positionInitialized",
           vehicle.navigation_reason != "no_pose"}};
}

const char* position_name(const Gateway& gateway) {
  return is_new(gateway) ? "mobileRobotPosition" : "agvPosition";
}

const char* mode_word(const Gateway& gateway, const Vehicle& vehicle) {
  switch (gateway.mode(vehicle)) {
    case Mode::automatic:
      return "AUTOMATIC";
    case Mode::intervened:
      return is_new(gateway) ? "INTERVENED" : "MANUAL";
    case Mode::startup:
      return is_new(gateway) ? "STARTUP" : "MANUAL";
    case Mode::manual:
      break;
  }
  return "MANUAL";
}

json power_in(const Gateway& gateway, const Vehicle& vehicle) {
  json power = {{is_new(gateway) ? "stateOfCharge" : "batteryCharge", vehicle.charge_percent},
                {"charging", vehicle.is_charging}};
  if (vehicle.voltage_v) power["batteryVoltage"] = *vehicle.voltage_v;
  return power;
}

json safety_in(const Gateway& gateway, const Vehicle& vehicle) {
  const char* stop = !vehicle.emergency_stop      ? "NONE"
                     : vehicle.stopped_by_station ? "REMOTE"
                                                  : "MANUAL";
  return {{is_new(gateway) ? "activeEmergencyStop" : "eStop", stop},
          {"fieldViolation", vehicle.bumper}};
}

bool is_docking(const Vehicle& vehicle) {
  return !vehicle.docking.empty() && vehicle.docking != "idle" && vehicle.docking != "done";
}

/// What says nothing new when it changes.
void drop_what_changes_always(json& state) {
  for (const char* name : {"mobileRobotPosition", "agvPosition", "information"}) state.erase(name);
  for (const char* name : {"powerSupply", "batteryState"}) {
    if (const auto power = state.find(name); power != state.end()) {
      *power = power->at("charging");
    }
  }
}

}  // namespace

json state_body(const Gateway& gateway, const Vehicle& vehicle) {
  const OrderBook& order = gateway.order();
  const Version version = gateway.identity().version;
  json actions = json::array();
  json instants = json::array();
  add_actions(actions, order.actions(), version);
  add_actions(is_new(gateway) ? instants : actions, gateway.instant_actions(), version);
  json state = {{"orderId", order.id()},
                {"orderUpdateId", order.update()},
                {"lastNodeId", order.last_node()},
                {"lastNodeSequenceId", order.last_sequence()},
                {"nodeStates", nodes_in(order, gateway.capabilities())},
                {"edgeStates", edges_in(order)},
                {"driving", vehicle.navigation == "driving" || is_docking(vehicle)},
                {"paused", gateway.is_paused(vehicle)},
                {"newBaseRequest", gateway.wants_base()},
                {"actionStates", std::move(actions)},
                {"operatingMode", mode_word(gateway, vehicle)},
                {"errors", errors_in(gateway, vehicle)},
                {"information", information_in(gateway, vehicle)},
                {"safetyState", safety_in(gateway, vehicle)},
                {"maps", json::array({{{"mapId", gateway.capabilities().map_id},
                                       {"mapVersion", "1"},
                                       {"mapStatus", "ENABLED"}}})},
                {is_new(gateway) ? "powerSupply" : "batteryState", power_in(gateway, vehicle)}};
  if (is_new(gateway)) state["instantActionStates"] = std::move(instants);
  if (vehicle.pose) state[position_name(gateway)] = position_in(gateway, vehicle);
  return state;
}

json visualization_body(const Gateway& gateway, const Vehicle& vehicle) {
  return {{position_name(gateway), position_in(gateway, vehicle)}};
}

Message Publications::make(const std::string& topic, json body, std::int64_t wall_ns) {
  body["headerId"] = headers_[topic]++;
  body["timestamp"] = timestamp(wall_ns);
  body["version"] = identity_.version_text();
  body["manufacturer"] = identity_.manufacturer;
  body["serialNumber"] = identity_.serial_number;
  return {identity_.topic(topic), body.dump(-1, ' ', false, json::error_handler_t::replace)};
}

Message Publications::connection(const char* state, std::int64_t wall_ns) {
  Message made = make("connection", {{"connectionState", state}}, wall_ns);
  made.is_retained = true;
  made.qos = 1;
  return made;
}

Message Publications::will(std::int64_t wall_ns) {
  return connection(identity_.version == Version::v3_0 ? "CONNECTION_BROKEN" : "CONNECTIONBROKEN",
                    wall_ns);
}

Message Publications::farewell(std::int64_t wall_ns) { return connection("OFFLINE", wall_ns); }

void Publications::on_connected() {
  told_heard_.reset();
  wants_factsheet_ = wants_state_ = true;
}

std::optional<Message> Publications::state(Gateway& gateway, const Vehicle& vehicle, Time now,
                                           std::int64_t wall_ns) {
  if (gateway.take_state_request()) wants_state_ = true;
  if (now - last_state_ < seconds(least_apart_s)) return std::nullopt;
  json body = state_body(gateway, vehicle);
  json seen = body;
  drop_what_changes_always(seen);
  if (!wants_state_ && now < next_state_ && seen == told_) return std::nullopt;
  wants_state_ = false;
  told_ = std::move(seen);
  last_state_ = now;
  next_state_ = now + seconds(params_.state_period_s);
  state_header_ = headers_["state"];
  return make("state", std::move(body), wall_ns);
}

std::vector<Message> Publications::due(Gateway& gateway, const Vehicle& vehicle, Time now,
                                       std::int64_t wall_ns) {
  std::vector<Message> all;
  const bool is_heard = vehicle.silence_s < Gateway::broken_after_s;
  was_heard_ = was_heard_ || is_heard;
  if (told_heard_ != is_heard) {
    told_heard_ = is_heard;
    all.push_back(is_heard ? connection("ONLINE", wall_ns) : will(wall_ns));
  }
  if (gateway.take_factsheet_request() || wants_factsheet_) {
    wants_factsheet_ = false;
    all.push_back(make("factsheet", factsheet_body(identity_, gateway.capabilities()), wall_ns));
    all.back().is_retained = true;
  }
  if (!was_heard_) return all;
  if (auto message = state(gateway, vehicle, now, wall_ns)) all.push_back(std::move(*message));
  const bool shows = params_.visualization_period_s > 0 && vehicle.pose && is_heard;
  if (shows && now >= next_visualization_) {
    next_visualization_ = now + seconds(params_.visualization_period_s);
    json body = visualization_body(gateway, vehicle);
    if (identity_.version == Version::v3_0) body["referenceStateHeaderId"] = state_header_;
    all.push_back(make("visualization", std::move(body), wall_ns));
  }
  return all;
}

}  // namespace tocsin::vda5050
