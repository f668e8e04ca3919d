// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "foundation/parameters.hpp"
#include "foundation/time.hpp"
#include "rplidar_driver/turn_builder.hpp"
#include "rplidar_protocol/decoder.hpp"

namespace tocsin::rplidar {

enum class LaserState {
  no_port,
  asking,     ///< who it is and how it is
  unhealthy,  ///< it says that it has an error; it is started anew
  starting,   ///< the first turn is awaited
  scanning,
  silent,   ///< it has sent nothing that is an answer
  stalled,  ///< it sends, or should, but does not turn
};
[[nodiscard]] const char* to_text(LaserState state);

/// Brings an RPLIDAR to scan, keeps it scanning, and assembles its turns. Whatever fails is tried
/// again with pauses that double from 1 to 10 s.
///
/// Pure: bytes and `now` in, bytes and turns out. `now` must not decrease.
class RplidarDriver {
 public:
  struct Params {
    TurnParams turn;
    bool express = false;
    int motor_duty = 660;
    double turn_timeout_s = 2;
    template <class Visitor>
    void visit(Visitor& v) {
      turn.visit(v);
      v("express", express, "asks for express scans: twice the readings, no light intensity");
      v("motor_duty", motor_duty, {0, 1023},
        "[1] of the motor of an A2; an A1 has none, and passes it over");
      v("turn_timeout_s", turn_timeout_s, {0.3, 30}, "[s] without a whole turn: the motor stalls");
    }
  };
  using ByteSink = std::function<void(const Bytes& bytes)>;
  using TurnSink = std::function<void(const Turn& turn)>;

  /// Throws what TurnBuilder throws.
  explicit RplidarDriver(const Params& params) : params_(params), turns_(params.turn) {}

  void on_port_open(Time now);
  void on_port_lost();
  void on_bytes(ByteView bytes, Time now, const TurnSink& sink);
  /// Sends what is due.
  void run(Time now, const ByteSink& sink);
  /// What ends its scan and its motor.
  [[nodiscard]] static std::vector<Bytes> farewell();

  [[nodiscard]] Time deadline() const { return deadline_; }
  [[nodiscard]] LaserState state() const { return state_; }
  [[nodiscard]] const std::optional<Info>& info() const { return info_; }
  [[nodiscard]] const std::optional<Health>& health() const { return health_; }
  [[nodiscard]] const Decoder::Counts& counts() const { return decoder_.counts(); }
  [[nodiscard]] const TurnBuilder& turns() const { return turns_; }
  /// [Hz] of the last turn; 0 before it.
  [[nodiscard]] double turn_hz() const { return turn_hz_; }

 private:
  /// What is awaited until the deadline.
  enum class Phase { closed, quiet, info, health, scan, boot };
  void take(const Answer& answer, Time now, std::vector<Reading>& readings);
  void take_readings(const std::vector<Reading>& readings, Time now, const TurnSink& sink);
  void on_turn(const Turn& turn, Time now, const TurnSink& sink);
  void go_on(Time now, const ByteSink& sink);
  void fail(LaserState why, Time now, const ByteSink& sink);
  void begin_scan(Time now, const ByteSink& sink);
  void enter(Phase phase, Time deadline);

  Params params_;
  Decoder decoder_;
  TurnBuilder turns_;
  Phase phase_ = Phase::closed;
  Time deadline_ = never;
  LaserState state_ = LaserState::no_port;
  double pause_s_ = 1;
  std::optional<Info> info_;
  std::optional<Health> health_;
  bool has_answered_ = false;  ///< since the phase began
  double reading_s_ = 0;       ///< from reading to reading, by the last turn
  int turn_readings_ = 0;
  double turn_hz_ = 0;
};

}  // namespace tocsin::rplidar
