// SPDX-License-Identifier: Apache-2.0
#include "link_router/least_age.hpp"

#include <algorithm>

namespace tocsin::router {
namespace {

using std::chrono::milliseconds;

constexpr Duration burst = milliseconds(50);
/// Nothing was received for longer: the least age is of before.
constexpr Duration silence = std::chrono::seconds(1);
constexpr Duration very_old = std::chrono::seconds(2);
constexpr int very_old_means_step = 8;
/// More than a healthy queue of the radio takes.
constexpr Duration old = milliseconds(250);
constexpr Duration old_for = milliseconds(1200);
constexpr int old_at_least = 3;
constexpr Duration settling = milliseconds(250);

}  // namespace

Duration LeastAge::age(Time sent, Time now) {
  const Duration seen = now.time_since_epoch() - sent.time_since_epoch();
  if (least_.value() && now - heard_ > silence) least_.skip(now - heard_);
  if (!least_.value()) begun_ = now;
  heard_ = now;
  least_.add(seen, now);
  const Duration age = seen - *least_.value();
  if (is_refuted(age, now)) {
    least_.clear();
    aged_ = {};
  }
  return age;
}

bool LeastAge::is_settled(Time now) const { return now - begun_ >= settling; }

bool LeastAge::is_refuted(Duration age, Time now) {
  if (age <= old) {
    aged_ = {};
    return false;
  }
  if (aged_.late > 0 && now - aged_.counted < burst) return false;
  if (aged_.late == 0 || age < aged_.first / 2) {
    aged_.since = now;
    aged_.first = age;
    aged_.late = 0;
  }
  ++aged_.late;
  aged_.very_late = age > very_old ? aged_.very_late + 1 : 0;
  aged_.counted = now;
  if (aged_.very_late >= very_old_means_step) return true;
  return aged_.late >= old_at_least && now - aged_.since >= old_for;
}

}  // namespace tocsin::router
