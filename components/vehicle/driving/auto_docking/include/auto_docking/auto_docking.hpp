// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "auto_docking/light_sweep.hpp"
#include "foundation/time.hpp"
#include "geometry/twist.hpp"
#include "kobuki_protocol/feedback.hpp"

namespace tocsin {

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
  scan,          ///< turning until the whole light of the dock has passed the middle receiver
  face,          ///< turning back to the middle of the light
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

/// Where the base is: on the dock's own left, in front of its middle, or on its right. The values
/// are signs: from the left the centre line is reached by a turn to the left, which is positive.
enum class DockSide { left = -1, centre = 0, right = 1 };

[[nodiscard]] const char* to_string(DockingState state);
[[nodiscard]] const char* to_string(DockingResult result);

/// Drives the base into its charging dock by the dock's infrared light.
///
/// It turns until the light has passed its middle receiver, which gives the bearing of the dock.
/// If it saw the centre beam, it faces the dock and drives in, holding that heading and leaning
/// towards the side that it must go to. Otherwise it crosses the centre line, at 60 degrees to the
/// bearing, as long as it sees light, and turns again. The states are those of the reference driver
/// (reference page 1.11), without its faults: every search has a limit, no drive goes on without
/// light, losing the charger continues the approach, a bump or the third loss of the charger backs
/// off far enough for another try.
/// Pure; `now` must not decrease.
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
    double start_s = 5;
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
      v("start_s", start_s, {0.05, 60}, "[s] it waits for the first sensors");
    }
  };

  explicit AutoDocking(const Params& params) : params_(params) {}
  void start(Time now);
  void cancel();
  /// Takes a frame and returns the velocity for it.
  geometry::Twist update(const DockingInput& input, Time now);
  /// Ends docking when sensors are silent; call now and then. True when it ended by this call. The
  /// first ones may take longer: a driver may just be starting.
  bool watch(Time now);

  [[nodiscard]] DockingState state() const { return state_; }
  [[nodiscard]] DockingResult result() const { return result_; }
  [[nodiscard]] bool running() const {
    return state_ != DockingState::idle && state_ != DockingState::done;
  }

 private:
  static constexpr std::size_t window = 20;     ///< signals of 0.4 s are OR-ed
  static constexpr int charged_updates = 21;    ///< so long it must last
  static constexpr int most_contacts_lost = 3;  ///< then it backs off and comes anew

  void finish(DockingResult result);
  void remember(const DockInfrared& infrared);
  [[nodiscard]] bool check_limits(Time now);
  [[nodiscard]] bool handle_contact(const DockingInput& input, Time now);
  [[nodiscard]] bool contact_is_marginal();
  void back_off(Time now);
  void decide(const DockingInput& input, Time now);
  void begin_scan(Turn turn);
  void scan(const DockingInput& input);
  void turn_to_target();
  void get_stream(Time now);
  void align();
  [[nodiscard]] geometry::Twist velocity() const;
  [[nodiscard]] geometry::Twist aligned_velocity(double speed_mps, unsigned signals) const;
  /// A turn rate that brings the heading to `target_rad`, at most `limit`.
  [[nodiscard]] double hold(double target_rad, double limit_rad_s) const;

  Params params_;
  DockingState state_ = DockingState::idle;
  DockingResult result_ = DockingResult::none;
  std::array<DockInfrared, window> past_{};
  std::size_t past_at_ = 0;
  DockInfrared seen_;  ///< OR over the window
  LightSweep sweep_{Turn::left};
  DockSide side_ = DockSide::centre;  ///< by the last scan
  double target_rad_ = 0;             ///< heading to turn to or to hold
  double heading_rad_ = 0;
  int charging_for_ = 0;
  int contacts_lost_ = 0;  ///< since it last backed off
  Time started_{};
  Time backed_off_{};  ///< when backing off ends
  Time last_light_{};
  std::optional<Time> last_input_;
};

}  // namespace tocsin
