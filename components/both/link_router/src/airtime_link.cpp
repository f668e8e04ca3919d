// SPDX-License-Identifier: Apache-2.0
#include "airtime_link.hpp"

#include <algorithm>

#include "runtime/middleware/ros_stamp.hpp"

namespace tocsin {
namespace {

constexpr Duration use_period = std::chrono::seconds(1);

}  // namespace

AirtimeLink::AirtimeLink(Component& owner, const LinkParts& parts, Role role)
    : owner_(owner), share_(owner), parts_(parts), has_share_(role == Role::uxv) {}

void AirtimeLink::begin(Instant at) {
  if (const auto told = share_.take_latest()) {
    parts_.sender.set_vehicles(told->vehicles());
    if (has_share_ && !keeper_.has_site()) next_report_ = at.now;
    if (has_share_) keeper_.on_share(told->share(), told->fallback(), at.now);
  }
  parts_.receiver.set_acknowledgement_period(parts_.sender.acknowledgement_period());
  if (has_share_) parts_.sender.set_airtime_share(keeper_.share(at.now));
}

void AirtimeLink::finish(Instant at) {
  if (!keeper_.has_site() || at.now < next_report_) return;
  next_report_ = owner_.next_instant(use_period, at.now);
  topic::AirtimeUse::Message use;
  use.stamp(ros_stamp(at.wall_ns));
  use.used(static_cast<float>(std::min(parts_.sender.airtime_used(at.now), 1.0)));
  use.share(static_cast<float>(keeper_.share(at.now).value_or(1)));
  use.waited(parts_.sender.take_share_missed());
  if (!use_) use_.emplace(owner_);
  (void)use_->write(std::move(use));  // the next one replaces it
}

Time AirtimeLink::deadline(Time now) const {
  const Time changes = keeper_.deadline(now);
  return keeper_.has_site() ? std::min(changes, next_report_) : changes;
}

}  // namespace tocsin
