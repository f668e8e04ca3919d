// SPDX-License-Identifier: Apache-2.0
#include "navigator/send_stop.hpp"

#include <algorithm>

#include "foundation/numbers.hpp"

namespace tocsin {
namespace {

/// Fewer samples are on their way always; nobody stops for them, though at a goal all are waited
/// for.
constexpr std::uint64_t few = 3;
constexpr double least_needed_s = 1;
constexpr double rate_weight = 0.5;  // of the newest second
constexpr Duration patience = std::chrono::seconds(10);
constexpr double worthwhile_share = 0.5;  // of what crossed each second before
constexpr Duration store_timeout = std::chrono::seconds(5);

constexpr double good_risk = 0.2;  // worth standing at
constexpr double lost_risk = 0.5;
constexpr double better = 0.05;  // worth driving on to

/// The link along a way, until it is lost.
struct Ahead {
  bool is_lost = false;
  double link_s = 0;  // in which it is expected to be there until then
  double least_risk = 1;
};

Ahead look_ahead(const geometry::Path& way, double speed_mps, const navigation::LinkRisk& risk) {
  Ahead ahead;
  risk.walk(way, [&](double lost, double length_m) {
    ahead.least_risk = std::min(ahead.least_risk, lost);
    ahead.is_lost = lost > lost_risk;
    if (!ahead.is_lost) ahead.link_s += (1 - lost) * length_m / speed_mps;
    return !ahead.is_lost;
  });
  return ahead;
}

}  // namespace

void SendStop::on_store(const StoreBacklog& store, Time now) {
  const bool is_same_router = store.backfilled >= store_.backfilled;
  if (told_ && now > *told_ && is_same_router && store_.waiting >= few) {
    const double crossed = static_cast<double>(store.backfilled - store_.backfilled);
    if (crossed > 0) {
      const double rate = crossed / to_seconds(now - *told_);
      rate_ = rate_ == 0 ? rate : rate_ + rate_weight * (rate - rate_);
    }
  }
  if (!is_same_router && stand_) stand_->crossed = store.backfilled;
  store_ = store;
  told_ = now;
}

bool SendStop::waits(std::uint64_t least, Time now) const {
  return told_ && now - *told_ <= store_timeout && store_.waiting >= least;
}

double SendStop::needed_s() const {
  return rate_ == 0 ? infinity : static_cast<double>(store_.waiting) / rate_;
}

bool SendStop::may_begin(std::uint64_t goal, bool at_goal) const {
  return !stand_ || stand_->goal != goal || stand_->at_goal != at_goal;
}

void SendStop::begin(std::uint64_t goal, bool at_goal, Time now) {
  stand_ = Stand{goal, at_goal, now, now, store_.backfilled, rate_};
}

/// Each 10 s.
bool SendStop::is_worthwhile(Time now) {
  if (now - stand_->looked < patience) return true;
  const auto crossed = static_cast<double>(store_.backfilled - stand_->crossed);
  const double wanted = worthwhile_share * stand_->usual_rate * to_seconds(now - stand_->looked);
  stand_->looked = now;
  stand_->crossed = store_.backfilled;
  return crossed > 0 && crossed >= wanted;
}

bool SendStop::goes_on(double most_s, Time now) {
  if (stand_->is_over) return false;
  const bool ends = !waits(stand_->at_goal ? 1 : few, now) ||
                    now - stand_->since >= seconds(most_s) || !is_worthwhile(now);
  stand_->is_over = ends;
  return !ends;
}

bool SendStop::stands_at_goal(std::uint64_t goal, double most_s, Time now) {
  if (most_s <= 0) return false;
  if (may_begin(goal, true)) begin(goal, true, now);
  return goes_on(most_s, now);
}

bool SendStop::stands_on_way(std::uint64_t goal, const geometry::Path& way, double speed_mps,
                             const navigation::LinkRisk& risk, Time now) {
  if (params_.send_stop_s <= 0 || way.empty()) return false;
  if (!may_begin(goal, false)) return goes_on(params_.send_stop_s, now);
  if (!waits(few, now) || needed_s() < least_needed_s) return false;
  const double here = risk.at(way.front());
  if (here > good_risk) return false;
  const Ahead ahead = look_ahead(way, speed_mps, risk);
  if (!ahead.is_lost || needed_s() <= ahead.link_s || ahead.least_risk < here - better)
    return false;
  begin(goal, false, now);
  return true;
}

}  // namespace tocsin
