// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "vda5050_gateway/order.hpp"

namespace tocsin::vda5050 {

/// As `actionStatus` of a state has it.
enum class ActionStatus : std::uint8_t { waiting, initializing, running, finished, failed };
constexpr std::array<const char*, 5> words_of(ActionStatus) {
  return {"WAITING", "INITIALIZING", "RUNNING", "FINISHED", "FAILED"};
}

/// What has become of an action.
struct ActionState {
  Action action;
  ActionStatus status = ActionStatus::waiting;
  std::string result = {};
  std::uint32_t sequence = 0;  ///< of its node; 0 of an instant action
};

[[nodiscard]] inline bool has_ended(const ActionState& state) {
  return state.status == ActionStatus::finished || state.status == ActionStatus::failed;
}

/// The order that the vehicle has: which ones it takes over (figure 8 of the standard, version
/// 3.0), and how far it has come.
///
/// Pure. The first node of an order is where the vehicle stands, and counts as traversed at once.
class OrderBook {
 public:
  /// Where a new order may begin.
  struct Start {
    std::optional<geometry::Pose> pose;  ///< of the vehicle; nothing: not known
    double reach_m = 0.3;                ///< how far it may be from a node and be on it
  };
  enum class Taken : std::uint8_t { order, update, repetition };
  /// Takes over an order or an update of the present one. Otherwise says why not and stays as it
  /// was. `taken` says which, where it is not null.
  [[nodiscard]] std::optional<Fault> take(const Order& order, const Start& start, Version version,
                                          Taken* taken = nullptr);

  /// Nothing to drive to and nothing to do.
  [[nodiscard]] bool is_idle() const;
  /// The next released node is reached; its actions are due.
  void traverse();
  /// The order is over wherever it is; actions that have not ended fail.
  void clear();

  [[nodiscard]] const std::string& id() const { return id_; }
  [[nodiscard]] std::uint32_t update() const { return update_; }
  [[nodiscard]] const std::string& last_node() const { return last_node_; }
  [[nodiscard]] std::uint32_t last_sequence() const { return last_sequence_; }
  /// Not traversed yet, base and horizon.
  [[nodiscard]] const std::deque<Node>& nodes() const { return nodes_; }
  [[nodiscard]] const std::deque<Edge>& edges() const { return edges_; }
  [[nodiscard]] bool has_base() const { return !nodes_.empty() && nodes_.front().released; }
  [[nodiscard]] bool has_horizon() const { return !nodes_.empty() && !nodes_.back().released; }
  /// Released nodes up to the first one with something to do on it, which is driven to in one go.
  [[nodiscard]] std::vector<Node> leg() const;
  /// Of the order's nodes, the horizon's too.
  [[nodiscard]] const std::vector<ActionState>& actions() const { return actions_; }
  /// The action that is to be done now, or is being done, on the last node; null: none.
  [[nodiscard]] ActionState* due();
  /// All of it, for a successor; and from that. Nothing: it is none.
  [[nodiscard]] nlohmann::json save() const;
  [[nodiscard]] static std::optional<OrderBook> restore(const nlohmann::json& saved);
  /// Where the vehicle says that it stands, without an order: after its pose was set.
  void stand_on(const std::string& node) { last_node_ = node; }

 private:
  [[nodiscard]] std::optional<Fault> refuse_new(const Order& order, const Start& start,
                                                Version version) const;
  [[nodiscard]] std::optional<Fault> refuse_update(const Order& order) const;
  [[nodiscard]] bool has_in_base(const std::string& action) const;
  void begin(const Order& order);
  void extend(const Order& order);
  void append(const Order& order);
  void drop_horizon();

  std::string id_;
  std::uint32_t update_ = 0;
  std::string content_;  // of the last message that was taken over
  std::string last_node_;
  std::uint32_t last_sequence_ = 0;
  std::string decision_node_;  // the last one of the base
  std::uint32_t decision_sequence_ = 0;
  bool was_cleared_ = false;
  std::deque<Node> nodes_;
  std::deque<Edge> edges_;
  std::vector<ActionState> actions_;
};

}  // namespace tocsin::vda5050
