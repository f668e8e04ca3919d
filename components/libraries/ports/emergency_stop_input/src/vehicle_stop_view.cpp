// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop_input/vehicle_stop_view.hpp"

#include <algorithm>
#include <utility>

namespace tocsin {

void VehicleStopView::on_link(Report report, double silence_s, Time now) {
  if (silence_s < to_seconds(counts_for)) link_ = {std::move(report), now};
}

std::optional<VehicleStopView::Report> VehicleStopView::report() const {
  if (!status_ && !link_) return std::nullopt;
  if (!status_ || !link_) return status_ ? status_->report : link_->report;
  const bool link_is_last = link_->time >= status_->time;
  const Received& last = link_is_last ? *link_ : *status_;
  const Received& other = link_is_last ? *status_ : *link_;
  Report merged = last.report;
  if (!other.report.stands || last.time - other.time >= counts_for) return merged;
  merged.stands = true;
  for (const std::string& name : other.report.stopped_by) {
    const auto& names = merged.stopped_by;
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      merged.stopped_by.push_back(name);
    }
  }
  return merged;
}

}  // namespace tocsin
