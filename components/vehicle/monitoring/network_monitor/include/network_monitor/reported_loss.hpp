// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>

#include "foundation/time.hpp"

namespace tocsin::network {

/// Whose word the packet error rate is.
enum class LossSource { probes, routers };
inline constexpr auto words_of(LossSource) { return std::array{"probes", "routers"}; }

/// The packet error rate by the losses that the routers of both sides report once a second: what a
/// probe would meet on its way there and back. Pure; `now` never decreases.
class ReportedLoss {
 public:
  /// Whose router says how much of what it sent was lost.
  enum class Side { own, other };
  /// A report counts for so long.
  static constexpr Duration lasts = std::chrono::seconds(3);

  /// `loss` [0, 1]; another value, or NaN, is not taken.
  void on_report(Side side, double loss, Time now);
  /// [%] [0, 100]. Without a report of the other side, which may be what was lost, by the own one.
  /// Empty while the own router is silent.
  [[nodiscard]] std::optional<double> per_percent(Time now) const;

 private:
  struct Report {
    double loss = 0;
    Time at{};
  };
  [[nodiscard]] std::optional<double> loss_of(Side side, Time now) const;

  std::array<std::optional<Report>, 2> reports_;
};

}  // namespace tocsin::network
