// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "foundation/time.hpp"

namespace tocsin {

/// Decides which of several operators drives the vehicle: one at a time, known by name.
///
/// Control is free until somebody drives, and again when the driver has given no command for
/// `idle_s`. Who asks for it while another drives gets it when the driver gives it, lets go, or
/// does not answer for `answer_s`; a driver who keeps it is not asked again by that. Of several who
/// ask, the first waits and the others ask again. A supervisor takes it at once: that one is, the
/// station has checked. Pure; `now` must not decrease.
class DriverAuthority {
 public:
  struct Params {
    double idle_s = 2;
    double answer_s = 10;
    template <class Visitor>
    void visit(Visitor& v) {
      v("idle_s", idle_s, {0.5, 60}, "[s] without a command, and another operator may drive");
      v("answer_s", answer_s, {1, 600},
        "[s] for the driver's answer to who asks for control; then it is his");
    }
  };

  explicit DriverAuthority(const Params& params)
      : idle_(seconds(params.idle_s)), answer_(seconds(params.answer_s)) {}
  /// A command of `name`: whether it is to be followed.
  [[nodiscard]] bool follows(const std::string& name, Time now);
  void ask(const std::string& name, Time now);
  /// Of somebody who does not drive: nothing.
  void give(const std::string& name, Time now);
  void keep(const std::string& name);
  void take(const std::string& name, Time now);
  /// What time alone has changed. Call before reading, at the latest at `next_deadline`.
  void settle(Time now);

  [[nodiscard]] const std::optional<std::string>& driver() const { return driver_; }
  [[nodiscard]] const std::optional<std::string>& asked_by() const { return asked_by_; }
  /// Commands that were not followed.
  [[nodiscard]] std::uint32_t refused() const { return refused_; }
  /// When time alone changes something; `never` while nobody drives.
  [[nodiscard]] Time next_deadline() const;

 private:
  void hand_over(Time now);

  const Duration idle_;
  const Duration answer_;
  std::optional<std::string> driver_;
  Time last_command_{};
  std::optional<std::string> asked_by_;
  Time asked_{};
  std::uint32_t refused_ = 0;
};

}  // namespace tocsin
