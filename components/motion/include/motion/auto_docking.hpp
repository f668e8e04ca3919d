// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "foundation/time.hpp"
#include "kobuki_protocol/feedback.hpp"
#include "kobuki_protocol/velocity.hpp"

namespace tocsin::motion {

using kobuki::BodyVelocity;
using kobuki::DockInfrared;

/// What docking looks at, once per frame (50 Hz).
struct DockingInput {
  DockInfrared infrared;
  std::uint8_t bumper = 0;
  std::uint8_t charger = 0;
  double heading_rad = 0;  ///< of odometry; only differences count
};

enum class DockingState {
  idle,
  scan,          ///< turning, looking for the dock
  find_stream,   ///< beside the dock's centre line: turning across it
  get_stream,    ///< driving across the centre line
  aligned_far,   ///< driving in
  aligned_near,  ///< driving in, close
  bumped,        ///< backing off an obstacle
  bumped_dock,   ///< pressed against the dock, already charging
  docked_in,     ///< charging; waiting whether it lasts
  done
};

enum class DockingResult { none, docked, no_dock_found, timeout, cancelled, sensors_lost };

[[nodiscard]] const char* to_string(DockingState state);
[[nodiscard]] const char* to_string(DockingResult result);

/// Drives the base into its charging dock by the dock's infrared light.
///
/// The states and speeds of the reference driver (reference page 1.11) without its faults: every
/// search has a limit, losing the charger continues the approach, a bump backs off far enough for
/// another try, a base askew in the centre beam turns first, and there is no step of 0.5 m/s. Pure;
/// `now` must not decrease.
class AutoDocking {
 public:
  struct Params {
    double timeout_s = 120;
    double search_s = 40;
    double scan_turn_rad_s = 0.66;
    double find_turn_rad_s = 0.33;
    double near_mps = 0.05;
    double far_mps = 0.1;
    double back_off_s = 4;
    double silence_s = 0.5;
    template <class Visitor>
    void visit(Visitor& v) {
      v("timeout_s", timeout_s, {5, 3600}, "[s] for everything");
      v("search_s", search_s, {5, 3600}, "[s] without any light of a dock");
      v("scan_turn_rad_s", scan_turn_rad_s, {0.1, 2}, "[rad/s] while scanning");
      v("find_turn_rad_s", find_turn_rad_s, {0.1, 2}, "[rad/s] while turning across the beam");
      v("near_mps", near_mps, {0.01, 0.3}, "[m/s] close to the dock");
      v("far_mps", far_mps, {0.01, 0.3}, "[m/s] far from the dock");
      v("back_off_s", back_off_s, {0.2, 20}, "[s] backwards at 0.05 m/s after a bump");
      v("silence_s", silence_s, {0.05, 10}, "[s] without sensors docking ends");
    }
  };

  explicit AutoDocking(const Params& params) : params_(params) {}
  void start(Time now);
  void cancel();
  /// Takes a frame and returns the velocity for it.
  BodyVelocity update(const DockingInput& input, Time now);
  /// Ends docking when sensors are silent; call now and then. True when it ended by this call.
  bool watch(Time now);

  [[nodiscard]] DockingState state() const { return state_; }
  [[nodiscard]] DockingResult result() const { return result_; }
  [[nodiscard]] bool running() const {
    return state_ != DockingState::idle && state_ != DockingState::done;
  }

 private:
  static constexpr std::size_t window = 20;   ///< signals of 0.4 s are OR-ed
  static constexpr int charged_updates = 21;  ///< so long it must last

  void finish(DockingResult result);
  void remember(const DockInfrared& infrared);
  [[nodiscard]] bool check_limits(Time now);
  [[nodiscard]] bool handle_contact(const DockingInput& input, Time now);
  void enter(DockingState state);
  void decide(const DockingInput& input, Time now);
  void scan(double heading_rad);
  void find_stream();
  void get_stream();
  void align();
  [[nodiscard]] BodyVelocity velocity() const;
  [[nodiscard]] BodyVelocity steer(double speed_mps, int beside, double turn_rad_s) const;
  [[nodiscard]] BodyVelocity aligned_velocity() const;

  Params params_;
  DockingState state_ = DockingState::idle;
  DockingResult result_ = DockingResult::none;
  std::array<DockInfrared, window> past_{};
  std::size_t past_at_ = 0;
  DockInfrared seen_;  ///< OR over the window
  int detector_ = 0;   ///< left sightings count down, right ones up
  double turned_rad_ = 0;
  double last_heading_rad_ = 0;
  bool has_heading_ = false;
  int charging_for_ = 0;
  Time started_{};
  Time backed_off_{};  ///< when backing off ends
  Time last_light_{};
  Time last_input_{};
};

}  // namespace tocsin::motion
