// SPDX-License-Identifier: Apache-2.0
// What a gateway that was started anew knows of the order.
#include "foundation/enum_words.hpp"
#include "vda5050_gateway/order_book.hpp"

namespace tocsin::vda5050 {
namespace {

nlohmann::json saved(const Action& action) {
  return {{"type", action.type}, {"id", action.id}, {"parameters", action.parameters}};
}

Action restored_action(const nlohmann::json& saved) {
  return {saved.at("type"), saved.at("id"), saved.at("parameters")};
}

nlohmann::json saved(const Node& node) {
  nlohmann::json made = {{"id", node.id},
                         {"sequence", node.sequence},
                         {"released", node.released},
                         {"x", node.pose.x_m},
                         {"y", node.pose.y_m},
                         {"heading", node.pose.heading_rad},
                         {"actions", nlohmann::json::array()}};
  for (const Action& action : node.actions) made["actions"].push_back(saved(action));
  return made;
}

Node restored_node(const nlohmann::json& saved) {
  Node node;
  node.id = saved.at("id");
  node.sequence = saved.at("sequence");
  node.released = saved.at("released");
  node.pose = {saved.at("x"), saved.at("y"), saved.at("heading")};
  for (const auto& action : saved.at("actions")) node.actions.push_back(restored_action(action));
  return node;
}

nlohmann::json saved(const ActionState& state) {
  return {{"action", saved(state.action)},
          {"status", word_of(state.status)},
          {"result", state.result},
          {"sequence", state.sequence}};
}

/// One that was under way begins again.
ActionState restored_state(const nlohmann::json& saved) {
  ActionState state{
      restored_action(saved.at("action")),
      value_of<ActionStatus>(saved.at("status").get<std::string>()).value_or(ActionStatus::waiting),
      saved.at("result"), saved.at("sequence")};
  if (!has_ended(state)) state.status = ActionStatus::waiting;
  return state;
}

}  // namespace

nlohmann::json OrderBook::save() const {
  nlohmann::json made = {{"id", id_},
                         {"update", update_},
                         {"content", content_},
                         {"last_node", last_node_},
                         {"last_sequence", last_sequence_},
                         {"decision_node", decision_node_},
                         {"decision_sequence", decision_sequence_},
                         {"was_cleared", was_cleared_},
                         {"nodes", nlohmann::json::array()},
                         {"edges", nlohmann::json::array()},
                         {"actions", nlohmann::json::array()}};
  for (const Node& node : nodes_) made["nodes"].push_back(saved(node));
  for (const Edge& edge : edges_) {
    made["edges"].push_back(
        {{"id", edge.id}, {"sequence", edge.sequence}, {"released", edge.released}});
  }
  for (const ActionState& state : actions_) made["actions"].push_back(saved(state));
  return made;
}

std::optional<OrderBook> OrderBook::restore(const nlohmann::json& saved) {
  OrderBook book;
  try {
    book.id_ = saved.at("id");
    book.update_ = saved.at("update");
    book.content_ = saved.at("content");
    book.last_node_ = saved.at("last_node");
    book.last_sequence_ = saved.at("last_sequence");
    book.decision_node_ = saved.at("decision_node");
    book.decision_sequence_ = saved.at("decision_sequence");
    book.was_cleared_ = saved.at("was_cleared");
    for (const auto& node : saved.at("nodes")) book.nodes_.push_back(restored_node(node));
    for (const auto& edge : saved.at("edges")) {
      book.edges_.push_back({edge.at("id"), edge.at("sequence"), edge.at("released")});
    }
    for (const auto& state : saved.at("actions")) book.actions_.push_back(restored_state(state));
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
  if (book.edges_.size() != book.nodes_.size()) return std::nullopt;
  return book;
}

}  // namespace tocsin::vda5050
