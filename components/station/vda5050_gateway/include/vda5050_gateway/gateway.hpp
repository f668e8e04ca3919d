// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "foundation/time.hpp"
#include "navigation/occupancy_map.hpp"
#include "vda5050_gateway/order_book.hpp"
#include "vda5050_gateway/vehicle.hpp"

namespace tocsin::vda5050 {

/// Who has the vehicle, as `operatingMode` of 3.0 has it; 2.1 knows the first and the last one.
/// `startup`: where it is, or who leads it, was not heard yet.
enum class Mode : std::uint8_t { automatic, intervened, startup, manual };

/// One vehicle as a fleet manager knows it: takes orders and instant actions, says what the vehicle
/// shall do, and what has become of it.
///
/// Pure. `now` must not decrease. The legs of an order's base are drives; an update makes the drive
/// longer without a halt. A drive that others take the place of ends the order: fleet control is
/// not in control then.
class Gateway {
 public:
  struct Params {
    Identity identity;
    Capabilities capabilities;
    double start_reach_m = 0.3;  ///< how far the vehicle may be from a node and be on it
    /// That nodes are checked against, for a robot of that radius; nothing: unchecked.
    std::optional<navigation::OccupancyMap> map;
    double robot_radius_m = 0.18;
  };
  /// Silence of the vehicle after which fleet control is told that the connection is broken.
  static constexpr double broken_after_s = 3;
  static constexpr std::size_t most_instant_actions = 100;

  explicit Gateway(Params params);
  /// Goes on with the order of a gateway before it, from what that has saved, as soon as position
  /// and mission are known: from where the mission is, where it is a leg of this order. Where
  /// others lead the vehicle, and in a pause, the order is over.
  void resume(OrderBook book);

  void on_order(const std::string& text, const Vehicle& vehicle);
  void on_instant_actions(const std::string& text, const Vehicle& vehicle, Time now);
  void on_drive(const DriveNews& news, Time now);
  /// What the vehicle shall do now, in this order. To be called some times a second.
  [[nodiscard]] std::vector<Request> update(const Vehicle& vehicle, Time now);

  [[nodiscard]] const Identity& identity() const { return params_.identity; }
  [[nodiscard]] const Capabilities& capabilities() const { return params_.capabilities; }
  [[nodiscard]] const OrderBook& order() const { return book_; }
  [[nodiscard]] const std::vector<ActionState>& instant_actions() const { return instants_; }
  [[nodiscard]] Mode mode(const Vehicle& vehicle) const;
  [[nodiscard]] bool is_paused(const Vehicle& vehicle) const;
  /// The base ends soon, and there is a horizon.
  [[nodiscard]] bool wants_base() const;
  [[nodiscard]] std::vector<Fault> faults(const Vehicle& vehicle) const;
  /// Whether fleet control has asked for a state, or for the factsheet, since the last call.
  [[nodiscard]] bool take_state_request() { return std::exchange(wants_state_, false); }
  [[nodiscard]] bool take_factsheet_request() { return std::exchange(wants_factsheet_, false); }

 private:
  struct Docking {
    std::string action;
    std::uint32_t run_before = 0;
    Time since{};
    Time asked{};
  };
  [[nodiscard]] bool is_new() const { return params_.identity.version == Version::v3_0; }
  [[nodiscard]] bool knows(const Vehicle& vehicle) const;
  void go_on(const Vehicle& vehicle, Time now);
  void refuse(Fault why);
  [[nodiscard]] std::optional<Fault> refuse_places(const Order& order) const;
  void begin_instant(const Action& action, const Vehicle& vehicle, Time now);
  void make_room(const Action& action);
  void begin(ActionState& state, const Vehicle& vehicle, Time now);
  void begin_cancel(ActionState& state);
  void begin_pose(ActionState& state, Time now);
  void fail_instant(ActionState& state, std::string why);
  void follow_mode(const Vehicle& vehicle, Time now);
  void follow_instants(const Vehicle& vehicle, Time now);
  void follow_pause(ActionState& state, const Vehicle& vehicle, Time now);
  void follow_pose(ActionState& state, const Vehicle& vehicle, Time now);
  void follow_cancel(Time now);
  void follow_node_actions(const Vehicle& vehicle, Time now);
  void begin_docking(ActionState& state, const Vehicle& vehicle, Time now);
  void follow_docking(ActionState& state, const Vehicle& vehicle, Time now);
  void drive_on(const Vehicle& vehicle, Time now);
  void end_drive(const DriveNews& news, Time now);
  void ask(Request::Kind kind, std::vector<geometry::Pose> poses = {}) {
    requests_.push_back({kind, std::move(poses)});
  }

  Params params_;
  OrderBook book_;
  std::vector<ActionState> instants_;
  std::vector<Fault> refused_;           // orders, until one is taken over
  std::optional<Fault> invalid_action_;  // until an instant action is taken
  std::optional<Fault> blocked_;         // of the present order
  std::vector<Request> requests_;

  bool is_resuming_ = false;  // an earlier order, once the vehicle is known
  Time resume_by_{};          // without the way of the mission
  bool pause_wanted_ = false;
  bool was_paused_ = false;               // since that was asked for
  Time pause_asked_{};                    // when that, or its end, was last asked for
  std::optional<std::string> canceling_;  // action that asked for it
  std::vector<std::uint32_t> drive_;      // sequence numbers of its nodes; empty: none is under way
  std::uint32_t reached_ = 0;             // of these
  Time quiet_since_{};                    // since when no drive is under way
  Time led_{};                            // when a drive was last known to be led, or none was
  std::optional<DriveNews> ended_badly_;  // while it is not known yet whether others drive
  bool is_foreign_ = false;               // others lead the vehicle
  Time try_again_{};
  std::optional<Docking> docking_;
  std::optional<Time> pose_asked_;
  bool wants_state_ = false;
  bool wants_factsheet_ = false;
};

}  // namespace tocsin::vda5050
