// SPDX-License-Identifier: Apache-2.0
#include "localisation/recent_scans.hpp"

#include "foundation/some_of.hpp"

namespace tocsin::localisation {
namespace {

constexpr std::size_t most_scans = 20;

}  // namespace

void RecentScans::move(const geometry::Pose& step) {
  for (Seen& seen : scans_) seen.from_here = relative(step, seen.from_here);
}

void RecentScans::add(const laser::Scan& scan) {
  scans_.push_front({{scan.laser, some_of(scan.hits, BeamModel::asked_beams), {}, {}}, {}});
  if (scans_.size() > most_scans) scans_.pop_back();
}

double RecentScans::advantage(const BeamModel& model, const geometry::Pose& pose,
                              const std::optional<geometry::Pose>& other, double least) const {
  double advantage = 0;
  double weight = witnesses;
  for (const Seen& seen : scans_) {
    const auto says = [&](const geometry::Pose& of) {
      return model.evidence_of(seen.scan, compose(of, seen.from_here)).log_likelihood;
    };
    advantage += weight * (says(pose) - (other ? says(*other) : 0));
    weight *= fading;
    if (advantage < least) break;
  }
  return advantage;
}

}  // namespace tocsin::localisation
