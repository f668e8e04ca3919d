// SPDX-License-Identifier: Apache-2.0
#include "link_router/stop_speaker.hpp"

#include <openssl/sha.h>

#include <algorithm>
#include <array>
#include <utility>

namespace tocsin::router {

StopToken lock_of(const StopToken& key) {
  std::array<unsigned char, SHA256_DIGEST_LENGTH> hash{};
  SHA256(key.data(), key.size(), hash.data());
  StopToken lock{};
  std::copy_n(hash.begin(), lock.size(), lock.begin());
  return lock;
}

void StopSpeaker::restore(const std::vector<Press>& presses) { presses_ = presses; }

void StopSpeaker::on_host(bool stands, Time now) {
  const bool has_ended = std::exchange(stands_, stands) && !stands;
  if (stands && (presses_.empty() || presses_.back().released)) {
    if (presses_.size() == most_presses) presses_.erase(presses_.begin());
    presses_.push_back({draw_(), false});
  }
  if (has_ended) release(presses_.back(), now);
  if (stands || now >= release_until_) return;
  for (Press& press : presses_) {
    if (!press.released) release(press, now);
  }
}

void StopSpeaker::release(Press& press, Time now) {
  press.released = true;
  say(press.key, now + released_said_for);
}

void StopSpeaker::say(const StopToken& key, Time until) {
  const auto found =
      std::find_if(said_.begin(), said_.end(), [&](const Said& one) { return one.key == key; });
  if (found != said_.end()) {
    found->until = std::max(found->until, until);
    return;
  }
  if (said_.size() == StopValue::most_tokens) said_.erase(said_.begin());
  said_.push_back({key, until});
}

void StopSpeaker::on_report(const std::vector<StopToken>& locks, Time now) {
  for (const Press& press : presses_) {
    if (!press.released) continue;
    if (std::find(locks.begin(), locks.end(), lock_of(press.key)) == locks.end()) continue;
    say(press.key, now + std::chrono::seconds(1));
  }
}

void StopSpeaker::fill(StopValue& value, Time now) const {
  value.stands = stands_;
  value.locks.clear();
  value.keys.clear();
  if (stands_) value.locks.push_back(lock_of(presses_.back().key));
  for (const Said& one : said_) {
    if (now < one.until) value.keys.push_back(one.key);
  }
}

}  // namespace tocsin::router
