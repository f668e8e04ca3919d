// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/thinning.hpp"

#include <algorithm>

namespace tocsin {

bool RateLimit::pass(Time now) {
  if (now + interval_ < next_) {
    ++dropped_;
    return false;
  }
  next_ = std::max(next_, now) + interval_;
  return true;
}

bool Separation::is_apart(const Key& key, Time now) {
  const auto [found, is_new] = last_.try_emplace(key, now);
  if (!is_new && now - found->second < least_) {
    ++dropped_;
    return false;
  }
  found->second = now;
  return true;
}

std::uint64_t DeadlineWatch::missed(Time now) const {
  if (period_ == Duration::max() || last_ == Time{} || now <= last_) return missed_;
  const Time since = std::max(last_, changed_);
  if (now <= since) return missed_;
  const Duration gap = now - since - Duration{1};  // a sample at the very deadline is in time
  return missed_ + static_cast<std::uint64_t>(gap / period_);
}

}  // namespace tocsin
