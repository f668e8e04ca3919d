// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "foundation/time.hpp"

namespace tocsin {

/// Whether the vehicle stands by an emergency stop, as the ground station knows it from two
/// reports: topic::SafetyStatus, a stream of changes, and topic::LinkStop, which rides in every
/// packet.
///
/// Rule: what was received last is true, and a stop that the other one reported less than a second
/// before counts, too. So either confirms a stop at once; and a SafetyStatus that is left from a
/// stream that has ended yields to a link that says otherwise for a second. A LinkStop whose value
/// is not fresh reports nothing.
///
/// Pure; `now` must not decrease.
class VehicleStopView {
 public:
  struct Report {
    bool stands = false;
    std::vector<std::string> stopped_by;
  };
  static constexpr Duration counts_for = std::chrono::seconds(1);

  void on_safety_status(Report report, Time now) { status_ = {std::move(report), now}; }
  /// `silence_s` as LinkStop has it; a value of `counts_for` or older is not fresh, nor is NaN.
  void on_link(Report report, double silence_s, Time now);
  /// Empty: the vehicle has not been received.
  [[nodiscard]] std::optional<Report> report() const;

 private:
  struct Received {
    Report report;
    Time time;
  };
  std::optional<Received> status_;
  std::optional<Received> link_;
};

}  // namespace tocsin
