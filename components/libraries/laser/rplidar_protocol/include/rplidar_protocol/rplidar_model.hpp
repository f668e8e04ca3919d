// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>

#include "foundation/time.hpp"
#include "rplidar_protocol/answer.hpp"

namespace tocsin::rplidar {

/// What kind of RPLIDAR is simulated. Figures of an A1M8 by its data sheet (LD108, v3.0).
struct ModelParams {
  std::uint8_t model = 0x18;
  double turn_hz = 5.5;
  double readings_per_s = 2000;  ///< of a plain scan; an express scan has twice as many
  double first_rad = 0;  ///< outside of this part of a turn, counter-clockwise, nothing returns
  double view_rad = 6.283185307179586;
  double spin_up_s = 1;           ///< from rest to full speed
  bool motor_by_request = false;  ///< A2: set_motor_pwm; A1: it turns from the start
};

/// An RPLIDAR as its computer sees it: takes requests, gives answers and readings with their
/// timing. What it looks at is a function of who simulates it. Pure; `now` must not decrease.
class RplidarModel {
 public:
  struct Look {
    double range_m = 0;  ///< infinity, NaN or 0: no return
    int quality = 47;    ///< [range 0,63]
  };
  /// What stands in a direction, counter-clockwise from ahead [rad], at a time.
  using Eye = std::function<Look(double bearing_rad, Time at)>;
  using Sink = std::function<void(ByteView bytes)>;

  RplidarModel(const ModelParams& params, Eye eye, Time now);

  /// Bytes of the computer, cut anywhere.
  void receive(ByteView bytes, Time now);
  /// Hands over what the device has sent until `now`, in packets of about 20 ms.
  void step(Time now, const Sink& sink);
  /// When `step` has something to do next; `never` when nothing is sent.
  [[nodiscard]] Time next_event() const;

  /// Somebody holds the rotor.
  void stall(bool held, Time now);
  void set_health(const Health& health) { health_ = health; }
  [[nodiscard]] bool is_scanning() const { return scan_.has_value(); }
  [[nodiscard]] bool is_turning(Time now) const;

 private:
  struct Scan {
    AnswerType type;
    Time next;              ///< of the next packet
    Time sampled;           ///< up to here readings are made
    bool is_first = true;   ///< capsule
    double before_rad = 0;  ///< angle of the last reading
  };
  void obey(const Request& request, Time now);
  void begin_scan(AnswerType type, Time now);
  void start_motor(bool on, Time now);
  void sample(Time until, const Sink& sink);
  [[nodiscard]] Bytes plain_readings(Time from, Time until, Time& done);
  [[nodiscard]] Bytes capsules(Time from, Time until, Time& done);
  [[nodiscard]] Reading reading_at(Time at) const;
  /// Clockwise since power-on.
  [[nodiscard]] double angle_at(Time at) const;
  [[nodiscard]] bool is_in_view(double clockwise_rad) const;

  ModelParams params_;
  Eye eye_;
  RequestReader requests_;
  Health health_;
  Bytes waiting_;  ///< answers that are not handed over yet
  std::optional<Time> boots_at_;
  std::optional<Time> full_speed_at_;  ///< empty: the motor stands
  bool is_held_ = false;
  std::optional<Scan> scan_;
};

}  // namespace tocsin::rplidar
