// SPDX-License-Identifier: Apache-2.0
#include "vda5050_gateway/order_book.hpp"

#include <algorithm>
#include <cmath>

#include "foundation/printable.hpp"

namespace tocsin::vda5050 {
namespace {

/// Whether a vehicle at `pose` is on the node: within its ellipse, widened by `reach_m`.
bool is_on(const Node& node, const geometry::Pose& pose, double reach_m) {
  const double dx = pose.x_m - node.pose.x_m;
  const double dy = pose.y_m - node.pose.y_m;
  const double c = std::cos(node.deviation_rad);
  const double s = std::sin(node.deviation_rad);
  const double along = (c * dx + s * dy) / (node.deviation_a_m + reach_m);
  const double across = (c * dy - s * dx) / (node.deviation_b_m + reach_m);
  return along * along + across * across <= 1;
}

Fault refusal(ErrorType type, std::string why, const Order& order) {
  return {type,
          std::move(why),
          {{"orderId", order.id}, {"orderUpdateId", std::to_string(order.update)}}};
}

}  // namespace

std::optional<Fault> OrderBook::take(const Order& order, const Start& start, Version version,
                                     Taken* taken) {
  const bool is_new = order.id != id_;
  const bool is_repetition = !is_new && order.update == update_ && order.content == content_;
  if (taken != nullptr) {
    *taken = is_new ? Taken::order : is_repetition ? Taken::repetition : Taken::update;
  }
  if (is_repetition) return std::nullopt;
  if (auto why = is_new ? refuse_new(order, start, version) : refuse_update(order)) return why;
  if (is_new) {
    begin(order);
  } else {
    extend(order);
  }
  update_ = order.update;
  content_ = order.content;
  return std::nullopt;
}

std::optional<Fault> OrderBook::refuse_new(const Order& order, const Start& start,
                                           Version version) const {
  if (!is_idle()) {
    return refusal(ErrorType::other_order_active,
                   "order '" + printable(id_) + "' is not over; cancel it first", order);
  }
  if (version == Version::v3_0 && order.update != 0) {
    return refusal(ErrorType::validation_failure,
                   "orderUpdateId of a new order is " + std::to_string(order.update) + ", not 0",
                   order);
  }
  const Node& first = order.nodes.front();
  if (first.sequence != 0) {
    return refusal(
        ErrorType::validation_failure,
        "nodes[0].sequenceId of a new order is " + std::to_string(first.sequence) + ", not 0",
        order);
  }
  if (start.pose && is_on(first, *start.pose, start.reach_m)) return std::nullopt;
  const std::string away = !start.pose
                               ? "the vehicle's position is not known"
                               : fixed_text(geometry::distance(geometry::position(*start.pose),
                                                               geometry::position(first.pose)),
                                            2) +
                                     " m away";
  return refusal(ErrorType::start_node_out_of_range,
                 "the first node, '" + printable(first.id) + "': " + away, order);
}

std::optional<Fault> OrderBook::refuse_update(const Order& order) const {
  const std::string present = std::to_string(update_);
  if (order.update < update_) {
    return refusal(ErrorType::outdated_order_update,
                   "orderUpdateId is " + std::to_string(order.update) + ", less than " + present,
                   order);
  }
  if (order.update == update_) {
    return refusal(ErrorType::same_order_update_id,
                   "orderUpdateId " + present + " with another content is there already", order);
  }
  if (was_cleared_) {
    return refusal(ErrorType::order_update_following_cancel, "the order was canceled", order);
  }
  const Node& first = order.nodes.front();
  if (first.id != decision_node_ || first.sequence != decision_sequence_) {
    return refusal(ErrorType::validation_failure,
                   "the first node is not '" + printable(decision_node_) + "' with sequenceId " +
                       std::to_string(decision_sequence_) + ", the last one of the base",
                   order);
  }
  for (const Node& node : order.nodes) {
    if (node.sequence == decision_sequence_) continue;
    for (const Action& action : node.actions) {
      if (!has_in_base(action.id)) continue;
      return refusal(ErrorType::validation_failure,
                     "actionId '" + printable(action.id) + "' is in the order already", order);
    }
  }
  return std::nullopt;
}

bool OrderBook::has_in_base(const std::string& action) const {
  return std::any_of(actions_.begin(), actions_.end(), [&](const ActionState& state) {
    return state.action.id == action && state.sequence <= decision_sequence_;
  });
}

void OrderBook::begin(const Order& order) {
  id_ = order.id;
  was_cleared_ = false;
  nodes_.clear();
  edges_.clear();
  actions_.clear();
  const Node& first = order.nodes.front();
  last_node_ = first.id;
  last_sequence_ = first.sequence;
  for (const Action& action : first.actions) {
    actions_.push_back({action, ActionStatus::waiting, "", first.sequence});
  }
  append(order);
}

void OrderBook::extend(const Order& order) {
  drop_horizon();
  append(order);
}

/// All but the first node, where the vehicle stands or what comes before ends.
void OrderBook::append(const Order& order) {
  for (std::size_t i = 1; i < order.nodes.size(); ++i) {
    const Node& node = order.nodes[i];
    nodes_.push_back(node);
    edges_.push_back(order.edges[i - 1]);
    for (const Action& action : node.actions) {
      actions_.push_back({action, ActionStatus::waiting, "", node.sequence});
    }
  }
  decision_node_ = order.nodes.front().id;
  decision_sequence_ = order.nodes.front().sequence;
  for (const Node& node : order.nodes) {
    if (!node.released) break;
    decision_node_ = node.id;
    decision_sequence_ = node.sequence;
  }
}

void OrderBook::drop_horizon() {
  while (has_horizon()) {
    nodes_.pop_back();
    edges_.pop_back();
  }
  const auto is_beyond = [this](const ActionState& state) {
    return state.sequence > decision_sequence_;
  };
  actions_.erase(std::remove_if(actions_.begin(), actions_.end(), is_beyond), actions_.end());
}

bool OrderBook::is_idle() const {
  return nodes_.empty() && std::all_of(actions_.begin(), actions_.end(), has_ended);
}

void OrderBook::traverse() {
  if (!has_base()) return;
  last_node_ = nodes_.front().id;
  last_sequence_ = nodes_.front().sequence;
  nodes_.pop_front();
  edges_.pop_front();
}

void OrderBook::clear() {
  was_cleared_ = true;
  nodes_.clear();
  edges_.clear();
  for (ActionState& state : actions_) {
    if (!has_ended(state)) state.status = ActionStatus::failed;
  }
}

std::vector<Node> OrderBook::leg() const {
  std::vector<Node> leg;
  for (const Node& node : nodes_) {
    if (!node.released) break;
    leg.push_back(node);
    if (!node.actions.empty()) break;
  }
  return leg;
}

ActionState* OrderBook::due() {
  for (ActionState& state : actions_) {
    if (state.sequence > last_sequence_) break;
    if (!has_ended(state)) return &state;
  }
  return nullptr;
}

}  // namespace tocsin::vda5050
