// SPDX-License-Identifier: Apache-2.0
// Goals of an action and what may become of them, as ROS 2's rcl_action has it. Pure.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "foundation/time.hpp"

namespace tocsin {

/// The UUID that the client has given to its goal.
using GoalId = std::array<std::uint8_t, 16>;
/// A UUID of version 4 (RFC 4122, section 4.4) of 16 random bytes.
[[nodiscard]] GoalId to_uuid(GoalId random);
/// 32 hexadecimal digits, as the tools of ROS 2 print it.
[[nodiscard]] std::string goal_text(const GoalId& id);

/// The numbers of action_msgs/msg/GoalStatus.
enum class GoalState : std::int8_t {
  unknown = 0,    ///< there is no such goal
  accepted = 1,   ///< and waits
  executing = 2,  ///< is being worked on
  canceling = 3,  ///< is being ended, as somebody has asked for it
  succeeded = 4,
  canceled = 5,
  aborted = 6,  ///< ended by its server
};
/// "EXECUTING".
[[nodiscard]] const char* to_text(GoalState state);
[[nodiscard]] bool is_over(GoalState state);

enum class GoalEvent { execute, cancel_goal, succeed, abort, canceled };
/// The state after an event; nothing where rcl_action does not allow it.
[[nodiscard]] std::optional<GoalState> after(GoalState state, GoalEvent event);

struct KnownGoal {
  GoalId id{};
  std::int64_t accepted_ns = 0;  ///< [ns] since the Unix epoch
  GoalState state = GoalState::accepted;
  Time ended{};  ///< once it is over
};

/// The numbers of action_msgs/srv/CancelGoal.
enum class CancelCode : std::int8_t { none = 0, rejected = 1, unknown_goal = 2, terminated = 3 };

/// Which goals somebody wants to end: that with the id, and those accepted at the stamp or before.
/// Without either, all.
struct CancelRequest {
  GoalId id{};
  std::int64_t stamp_ns = 0;  ///< [ns] since the Unix epoch; 0: none
};
struct CancelAnswer {
  CancelCode code = CancelCode::none;
  std::vector<KnownGoal> canceling = {};  ///< that are from now on
};

/// The goals of one server that it has accepted, with those that are over for a while.
class GoalTable {
 public:
  /// `kept`: how long a goal is known that is over.
  explicit GoalTable(Duration kept) : kept_(kept) {}

  /// False when there is one of this id.
  [[nodiscard]] bool add(const GoalId& id, std::int64_t accepted_ns);
  /// False when it is not allowed, or there is no such goal; nothing changes then.
  [[nodiscard]] bool apply(const GoalId& id, GoalEvent event, Time now);
  [[nodiscard]] CancelAnswer cancel(const CancelRequest& request, Time now);
  [[nodiscard]] GoalState state(const GoalId& id) const;
  /// In the order in which they were accepted.
  [[nodiscard]] const std::vector<KnownGoal>& all() const { return goals_; }
  /// Forgets those that are over for longer than `kept`, and says which.
  std::vector<GoalId> forget(Time now);

 private:
  [[nodiscard]] KnownGoal* find(const GoalId& id);
  const Duration kept_;
  std::vector<KnownGoal> goals_;
};

}  // namespace tocsin
