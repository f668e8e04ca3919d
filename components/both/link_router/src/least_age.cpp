// SPDX-License-Identifier: Apache-2.0
#include "link_router/least_age.hpp"

#include <algorithm>

namespace tocsin::router {
namespace {

using std::chrono::milliseconds;

constexpr Duration burst = milliseconds(50);
/// Nothing was received for longer: the least age is of before.
constexpr Duration silence = std::chrono::seconds(1);
constexpr Duration agreement = milliseconds(100);
constexpr int confirming = 3;
/// A lesser age that is received for shorter than this is no evidence.
constexpr Duration confirming_for = std::chrono::seconds(1);
/// A least age that was agreed with for less than `trusted_after` ends after so much of the
/// contrary.
constexpr Duration contradicted_for = std::chrono::seconds(2);
/// A row whose arrivals are farther apart begins anew.
constexpr Duration row_lasts = std::chrono::seconds(2);
constexpr Duration very_old = std::chrono::seconds(2);
constexpr int very_old_means_step = 8;
constexpr Duration settling = milliseconds(250);
/// A least age that is newer than this may have been learned of what had waited in a queue.
constexpr Duration doubted_for = std::chrono::seconds(2);
/// A least age that was agreed with for shorter may be a forger's.
constexpr Duration trusted_after = std::chrono::seconds(5);

}  // namespace

bool LeastAge::count(Row& row, int wanted, Duration seen, Time now) {
  if (row.arrivals > 0 && now - row.counted > row_lasts) row = {};
  if (row.arrivals == 0) {
    row = {1, now, now, seen};
    return false;
  }
  row.least = std::min(row.least, seen);
  if (now - row.counted < burst) return false;
  row.counted = now;
  return ++row.arrivals >= wanted;
}

void LeastAge::begin(Duration seen, Time since, Time now) {
  least_.clear();
  least_.add(seen, now);
  begun_ = since;
  agreed_ = now;
  hinted_ = seen;
  lesser_ = contrary_ = old_ = {};
}

Duration LeastAge::age(Time sent, Time now) {
  const Duration seen = now.time_since_epoch() - sent.time_since_epoch();
  if (least_.value() && now - received_ > silence) least_.skip(now - received_);
  received_ = now;
  if (!least_.value()) begin(seen, now, now);
  const bool is_doubted = now - begun_ < doubted_for;
  const Duration least = is_doubted ? std::min(hinted_, *least_.value()) : *least_.value();
  const Duration age = std::max(Duration{0}, seen - least);
  note(seen, now);
  return age;
}

Duration LeastAge::contradicted_after() const {
  const Duration agreed = agreed_ - begun_;
  return agreed < trusted_after ? std::min(agreed, contradicted_for) : agreed;
}

void LeastAge::note(Duration seen, Time now) {
  const Duration least = *least_.value();
  if (seen + agreement < least) {
    hinted_ = std::min(hinted_, seen);
    const bool said = count(lesser_, confirming, seen, now);
    if (said && now - lesser_.begun >= confirming_for) begin(lesser_.least, lesser_.begun, now);
    return;
  }
  least_.add(seen, now);
  if (seen <= least + agreement) {
    agreed_ = now;
    lesser_ = contrary_ = old_ = {};
    return;
  }
  const bool contradicted = count(contrary_, confirming, seen, now);
  const bool as_long = now - contrary_.begun >= contradicted_after();
  const bool was_set = seen - least > very_old && count(old_, very_old_means_step, seen, now);
  if (seen - least <= very_old) old_ = {};
  if (was_set || (contradicted && as_long)) begin(contrary_.least, contrary_.begun, now);
}

bool LeastAge::is_settled(Time now) const { return now - begun_ >= settling; }

}  // namespace tocsin::router
