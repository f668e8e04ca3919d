// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/medium.hpp"

#include <algorithm>

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

}  // namespace

Medium::Medium(const ChannelParams& params, Propagation& propagation, const Outages& outages,
               std::uint64_t seed, Time start)
    : propagation_(propagation),
      outages_(outages),
      errors_(frame_errors()),
      random_(seed, 3),
      background_(load_of(params)),
      idle_since_(start - difs),
      beacon_at_(start),
      heard_at_(start) {
  for (std::size_t i = 0; i < all_contenders; ++i) {
    Contender& one = contenders_[i];
    one.station = static_cast<int>(i % 2);
    one.single = i < singles;
    const AccessRules rules =
        one.single ? single_queue : access_rules(access_categories[(i - singles) / 2]);
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
  noise_dbm_ = params.noise_dbm;
  snr_offset_db_ = params.snr_offset_db;
  access_categories_ = params.access_categories;
  if (access_categories_) used_ = all_contenders;
}

std::size_t Medium::queued(int station) const {
  std::size_t sum = 0;
  for (const Contender& one : contenders_) sum += one.station == station ? one.queue.size() : 0;
  return sum;
}

Medium::Contender& Medium::contender_of(int station, AccessCategory category) {
  const auto first = static_cast<std::size_t>(station);
  if (!access_categories_) return contenders_[first];
  return contenders_[singles + 2 * static_cast<std::size_t>(category) + first];
}

bool Medium::enqueue(int station, const AirFrame& frame, Time now) {
  Contender& one = contender_of(station, frame.category);
  const std::size_t before = one.queue.size();
  if (before >= queue_frames_) return false;
  one.queue.push_back(frame);
  if (before == 0 && !busy_) join(one, now);
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
  contend(busy_until_, occupied_);
}

/// Whose backoff ends in the slot of `now`, by station; the others keep the slots that they have
/// left.
std::array<Medium::Contender*, 2> Medium::winners(Time now) {
  std::array<Contender*, 2> found{};
  for (std::size_t i = 0; i < used_; ++i) {
    Contender& one = contenders_[i];
    if (one.queue.empty()) continue;
    Contender*& winner = found[static_cast<std::size_t>(one.station)];
    if (one.ready >= now + slot_time / 2) {
      const Time counted_until = one.single ? now : std::max(now, one.counts_from);
      one.backoff = static_cast<int>((one.ready - counted_until + slot_time / 2) / slot_time);
    } else if (winner == nullptr) {
      winner = &one;  // the most urgent one of its station, since they are in that order
    } else {
      retry(one);
    }
  }
  return found;
}

void Medium::start_transmissions() {
  const Time now = access_at_;
  hear_beacons(now);
  const auto senders = winners(now);
  const bool collided = senders[0] != nullptr && senders[1] != nullptr;
  occupied_ = Duration::zero();
  for (Contender* one : senders) {
    if (one != nullptr) occupied_ = std::max(occupied_, transmit(*one, now, collided));
  }
  busy_ = true;
  busy_until_ = now + occupied_;
}

Duration Medium::transmit(Contender& one, Time now, bool collided) {
  Station& station = station_of(one);
  const AirFrame& frame = one.queue.front();
  const int bytes = frame.bytes + mac_overhead_bytes;
  one.sending = true;
  one.rate = frame.acknowledged
                 ? station.rates.rate(signal_.mean_dbm() - noise_dbm_, frame.attempt, attempts_)
                 : 0;
  Duration length = frame_duration(one.rate, bytes);
  const bool hit = collided || random_.chance(background_.collision());
  one.data_received = !hit && heard(one.rate, bytes, now);
  if (one.data_received) hear_frame(now);
  one.acknowledged =
      frame.acknowledged && one.data_received && heard(ack_rate(one.rate), ack_bytes, now + length);
  if (frame.acknowledged) length += sifs + frame_duration(ack_rate(one.rate), ack_bytes);
  ++station.counters.attempts;
  if (frame.attempt > 0) ++station.counters.retries;
  station.counters.airtime += length;
  return length;
}

void Medium::finish(Contender& one, std::vector<AirResult>& results) {
  Station& station = station_of(one);
  AirFrame& frame = one.queue.front();
  const AirResult result{frame.id, frame.bytes, frame.category, one.station, true, busy_until_};
  if (frame.acknowledged) station.rates.on_result(one.rate, frame.attempt, one.acknowledged);
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
  if (frame.acknowledged && !one.acknowledged) ++station.counters.failed;
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

bool Medium::heard(int rate, int bytes, Time now) {
  const double draw = random_.uniform();
  if (outages_.active(now) || propagation_.dead(now)) return false;
  const double snr_db = propagation_.rssi_dbm(now) - noise_dbm_ + snr_offset_db_;
  return !errors_.lost(rate, snr_db, bytes, draw);
}

void Medium::hear_frame(Time now) {
  signal_.on_frame(propagation_.rssi_dbm(now));
  heard_at_ = std::max(heard_at_, now);
}

void Medium::hear_beacons(Time now) {
  if (now < beacon_at_) return;
  const auto missed = (now - beacon_at_) / beacon_interval;
  if (missed >= remembered_beacons) {
    beacon_at_ += (missed - remembered_beacons + 1) * beacon_interval;
  }
  for (; beacon_at_ <= now; beacon_at_ += beacon_interval) {
    if (heard(0, beacon_bytes, beacon_at_)) hear_frame(beacon_at_);
  }
}

}  // namespace tocsin::radio
