// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/medium.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace tocsin::radio {
namespace {

constexpr Duration beacon_interval{102'400'000};
constexpr int beacon_bytes = 100;
constexpr int remembered_beacons = 8;
constexpr AccessRules single_queue{2, cw_min, cw_max};  // of the DCF: idle for DIFS
static_assert(sifs + single_queue.aifsn * slot_time == difs);

BackgroundLoad load_of(const ChannelParams& params) {
  return {params.background_load, params.background_stations, seconds(params.background_frame_s)};
}

/// -1 when the rate control chooses.
int fixed_rate(const ChannelParams& params) {
  for (int rate = 0; rate < rate_count; ++rate) {
    if (std::to_string(std::lround(rate_mbps(rate))) == params.data_rate) return rate;
  }
  return -1;
}

}  // namespace

Medium::Medium(const ChannelParams& params, const std::vector<Propagation*>& vehicles,
               const Outages& outages, std::uint64_t seed, Time start)
    : outages_(outages),
      errors_(frame_errors()),
      random_(seed, 3),
      background_(load_of(params)),
      winners_(vehicles.size() + 1),
      used_(winners_.size()),
      idle_since_(start - difs) {
  for (Propagation* const vehicle : vehicles) links_.push_back({vehicle, {}, {}, start, start});
  contenders_.resize(stations() * (1 + access_categories.size()));
  for (std::size_t i = 0; i < contenders_.size(); ++i) {
    Contender& one = contenders_[i];
    one.station = i % stations();
    if (one.station == links_.size()) one.queue = FrameQueue(links_.size());
    one.single = i < stations();
    const AccessRules rules =
        one.single ? single_queue : access_rules(access_categories[i / stations() - 1]);
    one.idle_time = sifs + rules.aifsn * slot_time;
    one.window = one.cw_min = rules.cw_min;
    one.cw_max = rules.cw_max;
  }
  set(params);
}

void Medium::configure(const ChannelParams& params) {
  background_ = load_of(params);
  set(params);
}

void Medium::set(const ChannelParams& params) {
  attempts_ = params.attempts;
  queue_frames_ = static_cast<std::size_t>(params.queue_frames);
  frame_lifetime_ = seconds(params.frame_lifetime_s);
  noise_dbm_ = params.noise_dbm;
  snr_offset_db_ = params.snr_offset_db;
  fixed_rate_ = fixed_rate(params);
  access_categories_ = params.access_categories;
  if (access_categories_) used_ = contenders_.size();
}

Duration Medium::airtime() const {
  Duration sum{0};
  for (const AirLink& link : links_) {
    sum += link.ways[0].counters.airtime + link.ways[1].counters.airtime;
  }
  return sum;
}

std::size_t Medium::queued(std::size_t vehicle, Direction direction) const {
  std::size_t sum = 0;
  const std::size_t station = direction == Direction::uplink ? vehicle : links_.size();
  for (const Contender& one : contenders_) {
    if (one.station == station) sum += one.queue.size(receiver_of(one, vehicle));
  }
  return sum;
}

Medium::Contender& Medium::contender_of(std::size_t station, AccessCategory category) {
  const std::size_t row = access_categories_ ? 1 + static_cast<std::size_t>(category) : 0;
  return contenders_[row * stations() + station];
}

bool Medium::enqueue(Direction direction, const AirFrame& frame, Time now) {
  const std::size_t station = direction == Direction::uplink ? frame.vehicle : links_.size();
  Contender& one = contender_of(station, frame.category);
  const std::size_t receiver = receiver_of(one, frame.vehicle);
  if (one.queue.size(receiver) >= queue_frames_) return false;
  const bool was_empty = one.queue.empty();
  AirFrame waiting = frame;
  waiting.queued = now;
  one.queue.push_back(receiver, waiting);
  if (was_empty && !busy_) join(one, now);
  return true;
}

void Medium::join(Contender& one, Time now) {
  one.ready = std::max({now, idle_since_ + one.idle_time, one.ready == never ? now : one.ready});
  const Duration occupied = background_.until_idle(random_);
  if (occupied > Duration::zero()) {
    const Time idle = one.single ? now + occupied : std::max(now + occupied, idle_since_);
    one.counts_from = idle + one.idle_time;
    one.ready = one.counts_from + random_.below(one.window + 1) * slot_time;
  }
  schedule_access();
}

void Medium::schedule_access() {
  access_at_ = never;
  for (std::size_t i = 0; i < used_; ++i) {
    const Contender& one = contenders_[i];
    if (!one.queue.empty()) access_at_ = std::min(access_at_, one.ready);
  }
}

void Medium::step(std::vector<AirResult>& results) {
  if (!busy_) {
    start_transmissions();
    return;
  }
  busy_ = false;
  for (std::size_t i = 0; i < used_; ++i) {
    if (contenders_[i].sending) finish(contenders_[i], results);
  }
  for (std::size_t i = 0; frame_lifetime_ > Duration::zero() && i < used_; ++i) {
    expire(contenders_[i], busy_until_, results);
  }
  contend(busy_until_, occupied_);
}

void Medium::expire(Contender& one, Time now, std::vector<AirResult>& results) {
  while (!one.queue.empty() && now - one.queue.front().queued > frame_lifetime_) {
    const AirFrame& frame = one.queue.front();
    if (!frame.received) {
      results.push_back({frame.id, frame.bytes, frame.category, frame.vehicle, direction_of(one),
                         false, true, now});
    }
    end_frame(one);
  }
}

/// Whose backoff ends in the slot of `now`, by station; the others keep the slots that they have
/// left.
void Medium::find_winners(Time now) {
  std::fill(winners_.begin(), winners_.end(), nullptr);
  for (std::size_t i = 0; i < used_; ++i) {
    Contender& one = contenders_[i];
    if (one.queue.empty()) continue;
    Contender*& winner = winners_[one.station];
    if (one.ready >= now + slot_time / 2) {
      const Time counted_until = one.single ? now : std::max(now, one.counts_from);
      one.backoff = static_cast<int>((one.ready - counted_until + slot_time / 2) / slot_time);
    } else if (winner == nullptr) {
      winner = &one;  // the most urgent one of its station, since they are in that order
    } else {
      retry(one);
    }
  }
}

void Medium::start_transmissions() {
  const Time now = access_at_;
  for (std::size_t i = 0; i < links_.size(); ++i) hear_beacons(i, now);
  find_winners(now);
  const auto silent = std::count(winners_.begin(), winners_.end(), nullptr);
  const bool collided = silent + 1 < static_cast<std::ptrdiff_t>(winners_.size());
  occupied_ = Duration::zero();
  for (Contender* one : winners_) {
    if (one != nullptr) occupied_ = std::max(occupied_, transmit(*one, now, collided));
  }
  busy_ = true;
  busy_until_ = now + occupied_;
}

/// Of the next attempt.
int Medium::rate_of(const Contender& contender) {
  const AirFrame& frame = contender.queue.front();
  if (!frame.acknowledged) return 0;
  if (fixed_rate_ >= 0) return fixed_rate_;
  const double snr_db = links_[frame.vehicle].signal.mean_dbm() - noise_dbm_;
  return way_of(contender).rates.rate(snr_db, frame.attempt, attempts_);
}

Duration Medium::transmit(Contender& one, Time now, bool collided) {
  const AirFrame& frame = one.queue.front();
  AirLink& link = links_[frame.vehicle];
  AirCounters& counters = way_of(one).counters;
  const int bytes = frame.bytes + mac_overhead_bytes;
  one.sending = true;
  one.rate = rate_of(one);
  Duration length = frame_duration(one.rate, bytes);
  const bool hit = collided || random_.chance(background_.collision());
  one.data_received = !hit && heard(link, one.rate, bytes, now);
  if (one.data_received) hear_frame(link, now);
  one.acknowledged = frame.acknowledged && one.data_received &&
                     heard(link, ack_rate(one.rate), ack_bytes, now + length);
  if (frame.acknowledged) length += sifs + frame_duration(ack_rate(one.rate), ack_bytes);
  ++counters.attempts;
  if (frame.attempt > 0) ++counters.retries;
  counters.airtime += length;
  one.queue.spend(length);
  return length;
}

void Medium::finish(Contender& one, std::vector<AirResult>& results) {
  AirWay& way = way_of(one);
  AirFrame& frame = one.queue.front();
  const AirResult result{frame.id,          frame.bytes, frame.category, frame.vehicle,
                         direction_of(one), true,        false,          busy_until_};
  if (frame.acknowledged) way.rates.on_result(one.rate, frame.attempt, one.acknowledged);
  if (one.data_received && !frame.received) {
    frame.received = true;
    results.push_back(result);
  }
  one.sending = false;
  ++frame.attempt;
  const bool last = !frame.acknowledged || frame.attempt >= attempts_;
  if (!one.acknowledged && !last) {
    retry(one);
    return;
  }
  if (!frame.received) {
    results.push_back(result);
    results.back().received = false;
  }
  if (frame.acknowledged && !one.acknowledged) ++way.counters.failed;
  end_frame(one);
}

void Medium::retry(Contender& one) {
  one.window = std::min(2 * one.window + 1, one.cw_max);
  one.backoff = random_.below(one.window + 1);
}

void Medium::end_frame(Contender& one) {
  one.queue.pop_front();
  one.window = one.cw_min;
  one.backoff = random_.below(one.window + 1);  // also without a next frame: the post-backoff
}

void Medium::contend(Time now, Duration occupied) {
  Duration shortest = difs + cw_max * slot_time;
  for (std::size_t i = 0; i < used_; ++i) {
    Contender& one = contenders_[i];
    if (!one.backoff && !one.queue.empty()) one.backoff = random_.below(one.window + 1);
    if (one.backoff) shortest = std::min(shortest, one.idle_time + *one.backoff * slot_time);
  }
  idle_since_ = now + background_.interruptions(occupied + shortest, random_);
  for (std::size_t i = 0; i < used_; ++i) {
    Contender& one = contenders_[i];
    one.counts_from = idle_since_ + one.idle_time;
    one.ready = one.counts_from + one.backoff.value_or(0) * slot_time;
    one.backoff.reset();
  }
  schedule_access();
}

bool Medium::heard(const AirLink& link, int rate, int bytes, Time now) {
  const double draw = random_.uniform();
  if (outages_.active(now) || link.propagation->dead(now)) return false;
  const double snr_db = link.propagation->rssi_dbm(now) - noise_dbm_ + snr_offset_db_;
  return !errors_.lost(rate, snr_db, bytes, draw);
}

void Medium::hear_frame(AirLink& link, Time now) {
  link.signal.on_frame(link.propagation->rssi_dbm(now));
  link.heard_at = std::max(link.heard_at, now);
}

void Medium::hear_beacons(std::size_t vehicle, Time now) {
  AirLink& link = links_[vehicle];
  if (now < link.beacon_at) return;
  const auto missed = (now - link.beacon_at) / beacon_interval;
  if (missed >= remembered_beacons) {
    link.beacon_at += (missed - remembered_beacons + 1) * beacon_interval;
  }
  for (; link.beacon_at <= now; link.beacon_at += beacon_interval) {
    if (heard(link, 0, beacon_bytes, link.beacon_at)) hear_frame(link, link.beacon_at);
  }
}

}  // namespace tocsin::radio
