// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "foundation/time.hpp"
#include "kobuki_protocol/command.hpp"
#include "kobuki_protocol/feedback.hpp"

namespace tocsin::kobuki {

/// Asks the base for versions, id and gains until it has answered, with growing pauses.
///
/// Gains are asked only of firmware that has them; the reference driver asks older ones fifty times
/// a second for ever. Pure; `now` must not decrease.
class Inquiry {
 public:
  static constexpr Duration first_pause = std::chrono::milliseconds(100);
  static constexpr Duration longest_pause = std::chrono::seconds(10);

  /// A base has been heard for the first time, or again after a silence: ask anew.
  void begin(Time now);
  void on_feedback(const Feedback& feedback);
  /// They were set: what was known is old.
  void forget_gains();
  /// What it has answered may be noise that looked like a frame: ask once more.
  void doubt_firmware() { doubts_firmware_ = true; }
  /// The request that is due now, if any. Call when it can be sent.
  [[nodiscard]] std::optional<Command> due(Time now);

  [[nodiscard]] const std::optional<Version>& hardware() const { return hardware_; }
  [[nodiscard]] const std::optional<Version>& firmware() const { return firmware_; }
  [[nodiscard]] const std::optional<UniqueId>& unique_id() const { return unique_id_; }
  [[nodiscard]] const std::optional<ControllerGains>& gains() const { return gains_; }

 private:
  [[nodiscard]] std::optional<Command> missing() const;

  std::optional<Version> hardware_;
  std::optional<Version> firmware_;
  std::optional<UniqueId> unique_id_;
  std::optional<ControllerGains> gains_;
  bool asked_for_gains_ = false;
  bool doubts_firmware_ = false;
  Duration pause_ = first_pause;
  Time next_ = Time::min();
};

}  // namespace tocsin::kobuki
