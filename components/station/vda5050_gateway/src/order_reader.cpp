// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include "foundation/numbers.hpp"
#include "foundation/printable.hpp"
#include "json_value.hpp"
#include "vda5050_gateway/order.hpp"

namespace tocsin::vda5050 {
namespace {

using nlohmann::json;

constexpr double half_turn = pi + 1e-9;  // the standard's schemas round pi up

/// An optional field that the vehicle cannot obey.
struct Unsupported {
  std::string field;
  std::string why;
};

/// What an optional field of an edge may be.
enum class Rule { never, at_least_speed, at_least_rotation, at_least_height, floor, yes, no };

struct EdgeField {
  const char* name;
  Rule rule;
};

/// Of both versions; what one of them does not have does not come.
constexpr EdgeField edge_fields[] = {
    {"maxSpeed", Rule::at_least_speed},
    {"maximumSpeed", Rule::at_least_speed},
    {"maxHeight", Rule::at_least_height},
    {"maximumMobileRobotHeight", Rule::at_least_height},
    {"minHeight", Rule::floor},
    {"minimumLoadHandlingDeviceHeight", Rule::floor},
    {"maxRotationSpeed", Rule::at_least_rotation},
    {"maximumRotationSpeed", Rule::at_least_rotation},
    {"rotationAllowed", Rule::yes},
    {"reachOrientationBeforeEntering", Rule::no},
    {"orientation", Rule::never},
    {"direction", Rule::never},
    {"trajectory", Rule::never},
    {"corridor", Rule::never},
};

void require_at_least(const JsonValue& value, double least) {
  const double limit = value.number();
  if (limit >= least) return;
  throw Unsupported{value.place(), "is " + shortest_text(limit) + ", less than the vehicle's " +
                                       shortest_text(least)};
}

void require_flag(const JsonValue& value, bool wanted) {
  if (value.flag() == wanted) return;
  throw Unsupported{value.place(), wanted ? "must be true" : "must be false"};
}

void check(Rule rule, const JsonValue& value, const Capabilities& vehicle) {
  switch (rule) {
    case Rule::never:
      throw Unsupported{value.place(), "is not supported"};
    case Rule::at_least_speed:
      return require_at_least(value, vehicle.speed_mps);
    case Rule::at_least_rotation:
      return require_at_least(value, vehicle.rotation_rad_s);
    case Rule::at_least_height:
      return require_at_least(value, vehicle.height_m);
    case Rule::floor:
      if (value.number() <= 0) return;
      throw Unsupported{value.place(), "is above 0: the vehicle has no load handling device"};
    case Rule::yes:
    case Rule::no:
      return require_flag(value, rule == Rule::yes);
  }
}

/// Other than the levels of the topic, they are for another vehicle.
void require_ours(const JsonValue& message, const char* key, const std::string& ours) {
  const JsonValue value = message.at(key);
  if (value.text() != ours) value.fail("is '" + printable(value.text()) + "', not '" + ours + "'");
}

void check_header(const JsonValue& message, const Identity& identity) {
  static_cast<void>(message.at("headerId").count());
  static_cast<void>(message.at("timestamp").text());
  const JsonValue version = message.at("version");
  const std::string major(identity.version_text(), 2);  // "3."
  if (version.text().compare(0, major.size(), major) != 0) {
    version.fail("is '" + printable(version.text()) + "', not " + identity.version_text());
  }
  require_ours(message, "manufacturer", identity.manufacturer);
  require_ours(message, "serialNumber", identity.serial_number);
}

Action read_action(const JsonValue& value, bool is_instant) {
  Action action{value.at("actionType").identifier(), value.at("actionId").identifier()};
  const JsonValue blocking = value.at("blockingType");
  const std::string& type = blocking.text();
  if (type != "NONE" && type != "SOFT" && type != "HARD" && (type != "SINGLE" || is_instant)) {
    blocking.fail("is '" + printable(type) + "', not NONE, SOFT, SINGLE or HARD");
  }
  if (const auto parameters = value.find("actionParameters")) {
    for (const JsonValue& one : parameters->items()) {
      action.parameters[one.at("key").identifier()] = one.at("value").json();
    }
  }
  return action;
}

std::vector<Action> read_actions(const JsonValue& value, bool is_instant) {
  std::vector<Action> actions;
  for (const JsonValue& item : value.items()) actions.push_back(read_action(item, is_instant));
  return actions;
}

void read_deviation(const JsonValue& value, Version version, Node& node) {
  if (version == Version::v2_1) {
    node.deviation_a_m = node.deviation_b_m = value.number_within(0, farthest_m);
    return;
  }
  node.deviation_a_m = value.at("a").number_within(0, farthest_m);
  node.deviation_b_m = value.at("b").number_within(0, farthest_m);
  node.deviation_rad = value.at("theta").number_within(-half_turn / 2, half_turn / 2);
}

/// `before`: the node before it, if any.
void read_position(const JsonValue& value, const Identity& identity, const Node* before,
                   Node& node) {
  node.pose.x_m = value.at("x").number_within(-farthest_m, farthest_m);
  node.pose.y_m = value.at("y").number_within(-farthest_m, farthest_m);
  if (const auto theta = value.find("theta")) {
    node.pose.heading_rad = theta->number_within(-half_turn, half_turn);
  } else if (before != nullptr) {
    node.pose.heading_rad =
        geometry::bearing(geometry::position(before->pose), geometry::position(node.pose));
  }
  if (const auto deviation = value.find("allowedDeviationXY")) {
    read_deviation(*deviation, identity.version, node);
  }
  if (const auto deviation = value.find("allowedDeviationTheta")) {
    static_cast<void>(deviation->number_within(-half_turn, half_turn));
  }
}

Node read_node(const JsonValue& value, const Identity& identity, const Node* before) {
  Node node;
  node.id = value.at("nodeId").identifier();
  node.sequence = value.at("sequenceId").count();
  node.released = value.at("released").flag();
  read_position(value.at("nodePosition"), identity, before, node);
  node.actions = read_actions(value.at("actions"), false);
  return node;
}

Edge read_edge(const JsonValue& value, const Capabilities& vehicle) {
  Edge edge{value.at("edgeId").identifier(), value.at("sequenceId").count(),
            value.at("released").flag()};
  for (const EdgeField& field : edge_fields) {
    if (const auto found = value.find(field.name)) check(field.rule, *found, vehicle);
  }
  return edge;
}

/// In 2.1 an edge names its nodes.
void check_ends(const JsonValue& edge, const Node& from, const Node& to) {
  if (edge.at("startNodeId").text() != from.id) {
    edge.at("startNodeId").fail("is not '" + printable(from.id) + "', the node before it");
  }
  if (edge.at("endNodeId").text() != to.id) {
    edge.at("endNodeId").fail("is not '" + printable(to.id) + "', the node after it");
  }
}

void check_numbers(const Order& order) {
  const std::uint64_t first = order.nodes.front().sequence;
  if (first % 2 != 0) throw Malformed("nodes[0].sequenceId is odd");
  for (std::size_t i = 0; i < order.nodes.size(); ++i) {
    if (order.nodes[i].sequence != first + 2 * i) {
      throw Malformed("nodes[" + std::to_string(i) + "].sequenceId is " +
                      std::to_string(order.nodes[i].sequence) + ", not " +
                      std::to_string(first + 2 * i));
    }
  }
  for (std::size_t i = 0; i < order.edges.size(); ++i) {
    if (order.edges[i].sequence != first + 2 * i + 1) {
      throw Malformed("edges[" + std::to_string(i) + "].sequenceId is " +
                      std::to_string(order.edges[i].sequence) + ", not " +
                      std::to_string(first + 2 * i + 1));
    }
  }
}

void check_released(const Order& order) {
  if (!order.nodes.front().released) throw Malformed("nodes[0].released is false");
  for (std::size_t i = 0; i < order.edges.size(); ++i) {
    const std::string place = "nodes[" + std::to_string(i + 1) + "].released";
    if (order.nodes[i + 1].released != order.edges[i].released) {
      throw Malformed(place + " is not as that of the edge before it");
    }
    if (order.nodes[i + 1].released && !order.nodes[i].released) {
      throw Malformed(place + " is true after a node that is not released");
    }
  }
}

void check_action_ids(const Order& order) {
  std::set<std::string> ids;
  for (const Node& node : order.nodes) {
    for (const Action& action : node.actions) {
      if (!ids.insert(action.id).second) {
        throw Malformed("actionId '" + printable(action.id) + "' is there twice");
      }
    }
  }
}

Fault fault(ErrorType type, const std::string& why, const Order& order) {
  Fault made{type, why};
  if (!order.id.empty()) {
    made.references = {{"orderId", order.id}, {"orderUpdateId", std::to_string(order.update)}};
  }
  return made;
}

std::optional<Fault> check_maps(const JsonValue& message, const Order& order,
                                const Capabilities& vehicle) {
  for (const JsonValue& node : message.at("nodes").items()) {
    const JsonValue map = node.at("nodePosition").at("mapId");
    if (map.text() == vehicle.map_id) continue;
    return fault(ErrorType::unknown_map_id,
                 map.place() + " is '" + printable(map.text()) + "', not '" + vehicle.map_id + "'",
                 order);
  }
  return std::nullopt;
}

std::optional<Fault> check_actions(const JsonValue& message, const Order& order) {
  for (const JsonValue& edge : message.at("edges").items()) {
    if (edge.at("actions").items().empty()) continue;
    return fault(ErrorType::invalid_order_action,
                 edge.place() + ".actions: there are none that the vehicle can do on an edge",
                 order);
  }
  for (const Node& node : order.nodes) {
    for (const Action& action : node.actions) {
      if (action.type == "startCharging") continue;
      return fault(
          ErrorType::invalid_order_action,
          "action '" + printable(action.type) + "' is not one that the vehicle can do on a node",
          order);
    }
  }
  return std::nullopt;
}

void read_nodes_and_edges(const JsonValue& message, const Identity& identity,
                          const Capabilities& vehicle, Order& order) {
  for (const JsonValue& node : message.at("nodes").items()) {
    const Node* before = order.nodes.empty() ? nullptr : &order.nodes.back();
    Node read = read_node(node, identity, before);
    order.nodes.push_back(std::move(read));
  }
  if (order.nodes.empty()) throw Malformed("nodes is empty");
  const auto edges = message.at("edges").items();
  if (edges.size() + 1 != order.nodes.size()) {
    throw Malformed("edges has " + std::to_string(edges.size()) + " items for " +
                    std::to_string(order.nodes.size()) + " nodes");
  }
  for (std::size_t i = 0; i < edges.size(); ++i) {
    if (identity.version == Version::v2_1) {
      check_ends(edges[i], order.nodes[i], order.nodes[i + 1]);
    }
    order.edges.push_back(read_edge(edges[i], vehicle));
  }
}

std::variant<Order, Fault> read_parts(const JsonValue& message, const Identity& identity,
                                      const Capabilities& vehicle, Order& order) {
  check_header(message, identity);
  order.update = message.at("orderUpdateId").count();
  order.id = message.at("orderId").identifier();
  if (message.at("nodes").items().size() > most_nodes) {
    return fault(ErrorType::insufficient_memory, "nodes: more than " + std::to_string(most_nodes),
                 order);
  }
  if (const auto zones = message.find("zoneSetId")) {
    throw Unsupported{zones->place(), "is not supported"};
  }
  read_nodes_and_edges(message, identity, vehicle, order);
  check_numbers(order);
  check_released(order);
  check_action_ids(order);
  if (auto wrong = check_maps(message, order, vehicle)) return *wrong;
  if (auto wrong = check_actions(message, order)) return *wrong;
  order.content = message.at("nodes").json().dump() + message.at("edges").json().dump();
  return order;
}

/// Throws Malformed.
json parse(const std::string& text) {
  if (text.size() > most_message_bytes) {
    throw Malformed("the message has " + std::to_string(text.size()) + " bytes, more than " +
                    std::to_string(most_message_bytes));
  }
  json message = json::parse(text, nullptr, false);
  if (message.is_discarded()) throw Malformed("the message is not JSON");
  return message;
}

}  // namespace

std::optional<double> Action::number(const std::string& key) const {
  const auto found = parameters.find(key);
  if (found == parameters.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

std::optional<std::string> Action::text(const std::string& key) const {
  const auto found = parameters.find(key);
  if (found == parameters.end() || !found->is_string()) return std::nullopt;
  return found->get<std::string>();
}

std::variant<Order, Fault> read_order(const std::string& text, const Identity& identity,
                                      const Capabilities& capabilities) {
  Order order;
  try {
    const json message = parse(text);
    return read_parts(JsonValue(message, ""), identity, capabilities, order);
  } catch (const Malformed& reason) {
    return fault(ErrorType::validation_failure, reason.what(), order);
  } catch (const Unsupported& reason) {
    Fault made = fault(ErrorType::unsupported_parameter, reason.field + " " + reason.why, order);
    made.references.emplace_back("parameter", reason.field);
    return made;
  }
}

std::variant<std::vector<Action>, Fault> read_instant_actions(const std::string& text,
                                                              const Identity& identity) {
  try {
    const json parsed = parse(text);
    const JsonValue message(parsed, "");
    check_header(message, identity);
    return read_actions(message.at("actions"), true);
  } catch (const Malformed& reason) {
    return Fault{ErrorType::validation_failure, reason.what(), {{"topic", "instantActions"}}};
  }
}

}  // namespace tocsin::vda5050
