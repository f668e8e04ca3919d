// SPDX-License-Identifier: Apache-2.0
#include "network_monitor/reported_loss.hpp"

#include <cstddef>

namespace tocsin::network {

void ReportedLoss::on_report(Side side, double loss, Time now) {
  if (loss >= 0 && loss <= 1) reports_[static_cast<std::size_t>(side)] = {loss, now};
}

std::optional<double> ReportedLoss::loss_of(Side side, Time now) const {
  const auto& report = reports_[static_cast<std::size_t>(side)];
  if (!report || now - report->at > lasts) return std::nullopt;
  return report->loss;
}

std::optional<double> ReportedLoss::per_percent(Time now) const {
  const auto there = loss_of(Side::own, now);
  if (!there) return std::nullopt;
  const double back = loss_of(Side::other, now).value_or(0);
  return 100 * (1 - (1 - *there) * (1 - back));
}

}  // namespace tocsin::network
