// SPDX-License-Identifier: Apache-2.0
#include "link_router/retransmitter.hpp"

#include <algorithm>
#include <cmath>

#include "link_router/link_constants.hpp"
namespace tocsin::router {
namespace {

/// Repairs that may follow each other at once.
constexpr double burst_bytes = 4000;

/// What waits for the pace of bulk and then crosses in pieces takes so long at most, but for luck.
constexpr Duration crossing = std::chrono::milliseconds(100);

bool is_of_same_source(const SentSample& one, const SentSample& other) {
  return one.stream == other.stream && one.sample.origin.source == other.sample.origin.source;
}

}  // namespace

Time Retransmitter::ends_at(const SentSample& sent) const {
  if (!sent.mends_with_bulk() || sent.expires == never) return sent.expires;
  return sent.expires - std::max(crossing, peers_.shared_delay());
}

void Retransmitter::supersede(const SentSample& newer, std::size_t depth) {
  for (const SentSamplePtr& older : open_) {
    if (!is_of_same_source(*older, newer)) continue;
    const std::size_t kept = older->whole ? depth + 1 : depth;
    // What is sent for a late peer is the newest one, or it is none.
    older->superseded = ++older->newer >= (older->counted ? kept : 1);
  }
}

void Retransmitter::end_older(const SentSample& delivered, std::size_t depth) {
  for (const SentSamplePtr& older : open_) {
    if (!older->whole || !is_of_same_source(*older, delivered)) continue;
    if (older->sample.origin.sequence < delivered.sample.origin.sequence && older->newer >= depth) {
      older->superseded = true;
    }
  }
}

void Retransmitter::forget_reader(PeerIndex peer, std::optional<StreamId> stream) {
  for (const SentSamplePtr& sent : open_) {
    if (stream && sent->stream != *stream) continue;
    auto& missing = sent->missing;
    missing.erase(std::remove(missing.begin(), missing.end(), peer), missing.end());
  }
}

std::vector<SentSamplePtr> Retransmitter::end_stream(StreamId stream) {
  std::vector<SentSamplePtr> ended;
  for (const SentSamplePtr& sent : open_) {
    if (sent->stream != stream) continue;
    sent->superseded = true;
    sent->under_way = 0;
    ended.push_back(sent);
  }
  return ended;
}

void Retransmitter::revive(Time now) {
  for (const SentSamplePtr& sent : open_) {
    sent->repair_at = std::min(sent->repair_at, now);
    sent->transmissions = std::min(sent->transmissions, 1U);
  }
}

void Retransmitter::revive_elsewhere(Time now) {
  revive(now);
  double lost_bytes = 0;
  for (const SentSamplePtr& sent : open_) {
    if (can_repair(*sent, now)) lost_bytes += static_cast<double>(sent->cost.bytes);
  }
  bytes_ = allowance(now) + lost_bytes;
  filled_ = now;
}

std::vector<SentSamplePtr> Retransmitter::conclude(Time now) {
  std::vector<SentSamplePtr> concluded;
  for (auto it = open_.begin(); it != open_.end();) {
    const SentSample& sent = **it;
    if (!sent.missing.empty() && (sent.under_way > 0 || can_repair(sent, now))) {
      ++it;
      continue;
    }
    concluded.push_back(*it);
    it = open_.erase(it);
  }
  return concluded;
}

void Retransmitter::schedule(SentSample& sent, Duration expected, Time now) const {
  if (sent.transmissions == 0) sent.first_sent = now;
  const double growth = std::pow(params_.repair_backoff, sent.transmissions);
  ++sent.transmissions;
  sent.repair_at =
      now + (expected + seconds(std::min(params_.repair_first_s * growth, repair_max_s)));
}

void Retransmitter::spend(std::size_t bytes, Time now) {
  rate_.add(bytes, now);
  bytes_ = allowance(now) - static_cast<double>(bytes);
  filled_ = now;
}

double Retransmitter::allowance(Time now) const {
  const double since_s = to_seconds(now - filled_);
  return std::min(bytes_ + bytes_per_s(now) * since_s, std::max(burst_bytes, bytes_));
}

double Retransmitter::bytes_per_s(Time now) const {
  return params_.repair_share * peers_.capacity_bytes_per_s(now) / peers_.vehicles();
}

bool Retransmitter::can_repair(const SentSample& sent, Time now) const {
  if (sent.missing.empty() || sent.superseded || now > ends_at(sent)) return false;
  if (!sent.counted || sent.is_repaired) return true;
  // Of a picture that nothing has arrived of, a fresh one is worth more.
  const bool may_be_mended = !sent.whole || sent.under_way > 0 || sent.whole->arrives;
  return may_be_mended && sent.cost.packets == 1 &&
         sent.transmissions <= static_cast<unsigned>(params_.low_repairs);
}

bool Retransmitter::may_repair(const SentSample& sent, Time now) const {
  return can_repair(sent, now) && !gate_.stops(sent.while_paused);
}

SentSamplePtr Retransmitter::due(TrafficClass traffic_class, Time now) const {
  if (open_.empty() || allowance(now) <= 0 || pacer_.repairs_open(now) > now) return nullptr;
  SentSamplePtr due;
  for (const SentSamplePtr& sent : open_) {
    if (sent->mends_with_bulk() || sent->traffic_class != traffic_class || sent->repair_at > now)
      continue;
    if (!may_repair(*sent, now)) continue;
    if (!due || sent->repair_at < due->repair_at) due = sent;
  }
  return due;
}

SentSamplePtr Retransmitter::due_with_bulk(TrafficClass traffic_class, Time now) const {
  const auto due = std::find_if(open_.begin(), open_.end(), [&](const SentSamplePtr& sent) {
    return sent->mends_with_bulk() && sent->under_way == 0 &&
           sent->traffic_class == traffic_class && sent->repair_at <= now && may_repair(*sent, now);
  });
  return due == open_.end() ? nullptr : *due;
}

Time Retransmitter::deadline(Time now) const {
  Time next = never;
  if (open_.empty()) return next;
  const Time from = ready(now);
  for (const SentSamplePtr& sent : open_) {
    if (!can_repair(*sent, now)) continue;
    if (sent->expires != never) next = std::min(next, ends_at(*sent) + Duration{1});
    if (sent->mends_with_bulk()) {
      // One that is due waits for the pace of bulk.
      if (sent->under_way == 0 && sent->repair_at > now) next = std::min(next, sent->repair_at);
    } else if (may_repair(*sent, now)) {
      next = std::min(next, std::max(sent->repair_at, from));
    }
  }
  return next;
}

Time Retransmitter::ready(Time now) const {
  const Time opens = pacer_.repairs_open(now);
  const double lacking = -allowance(now);
  if (lacking < 0) return opens;
  return std::max(opens, now + seconds((lacking + 1) / std::max(bytes_per_s(now), 1.0)));
}

double Retransmitter::share(Time now) const {
  return std::min(rate_.bytes_per_s(now) / peers_.capacity_bytes_per_s(now), 1.0);
}

}  // namespace tocsin::router
