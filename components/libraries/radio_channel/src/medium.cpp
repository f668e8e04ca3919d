// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/medium.hpp"

#include <algorithm>

namespace tocsin::radio {
namespace {

constexpr Duration beacon_interval{102'400'000};
constexpr int beacon_bytes = 100;
constexpr int remembered_beacons = 8;

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
}

bool Medium::enqueue(int station, const AirFrame& frame, Time now) {
  Side& s = side(station);
  const std::size_t before = s.queue.size();
  if (before >= queue_frames_) return false;
  s.queue.push_back(frame);
  if (before == 0 && !busy_) join(s, now);
  return true;
}

void Medium::join(Side& s, Time now) {
  s.ready = std::max({now, idle_since_ + difs, s.ready == never ? now : s.ready});
  const Duration occupied = background_.until_idle(random_);
  if (occupied > Duration::zero()) {
    s.ready = now + occupied + difs + random_.below(s.window + 1) * slot_time;
  }
  schedule_access();
}

void Medium::schedule_access() {
  access_at_ = never;
  for (const Side& s : sides_) {
    if (!s.queue.empty()) access_at_ = std::min(access_at_, s.ready);
  }
}

void Medium::step(std::vector<AirResult>& results) {
  if (!busy_) {
    start_transmissions();
    return;
  }
  busy_ = false;
  for (int station = 0; station < 2; ++station) {
    if (side(station).sending) finish(station, results);
  }
  contend(busy_until_, occupied_);
}

void Medium::start_transmissions() {
  const Time now = access_at_;
  hear_beacons(now);
  for (Side& s : sides_) {
    s.sending = !s.queue.empty() && s.ready < now + slot_time / 2;
    if (!s.sending && !s.queue.empty()) {
      s.backoff = static_cast<int>((s.ready - now + slot_time / 2) / slot_time);
    }
  }
  const bool collided = sides_[0].sending && sides_[1].sending;
  occupied_ = Duration::zero();
  for (Side& s : sides_) {
    if (s.sending) occupied_ = std::max(occupied_, transmit(s, now, collided));
  }
  busy_ = true;
  busy_until_ = now + occupied_;
}

Duration Medium::transmit(Side& s, Time now, bool collided) {
  const AirFrame& frame = s.queue.front();
  const int bytes = frame.bytes + mac_overhead_bytes;
  s.rate = frame.acknowledged
               ? s.rates.rate(signal_.mean_dbm() - noise_dbm_, frame.attempt, attempts_)
               : 0;
  Duration length = frame_duration(s.rate, bytes);
  const bool hit = collided || random_.chance(background_.collision());
  s.data_received = !hit && heard(s.rate, bytes, now);
  if (s.data_received) hear_frame(now);
  s.acknowledged =
      frame.acknowledged && s.data_received && heard(ack_rate(s.rate), ack_bytes, now + length);
  if (frame.acknowledged) length += sifs + frame_duration(ack_rate(s.rate), ack_bytes);
  ++s.counters.attempts;
  if (frame.attempt > 0) ++s.counters.retries;
  s.counters.airtime += length;
  return length;
}

void Medium::finish(int station, std::vector<AirResult>& results) {
  Side& s = side(station);
  AirFrame& frame = s.queue.front();
  if (frame.acknowledged) s.rates.on_result(s.rate, frame.attempt, s.acknowledged);
  if (s.data_received && !frame.received) {
    frame.received = true;
    results.push_back({frame.id, frame.bytes, station, true, busy_until_});
  }
  s.sending = false;
  ++frame.attempt;
  const bool last = !frame.acknowledged || frame.attempt >= attempts_;
  if (!s.acknowledged && !last) {
    retry(s);
    return;
  }
  if (!frame.received) results.push_back({frame.id, frame.bytes, station, false, busy_until_});
  if (frame.acknowledged && !s.acknowledged) ++s.counters.failed;
  end_frame(s);
}

void Medium::retry(Side& s) {
  s.window = std::min(2 * s.window + 1, cw_max);
  s.backoff = random_.below(s.window + 1);
}

void Medium::end_frame(Side& s) {
  s.queue.pop_front();
  s.window = cw_min;
  s.backoff = random_.below(s.window + 1);  // also without a next frame: the post-backoff
}

void Medium::contend(Time now, Duration occupied) {
  int fewest = cw_max;
  for (Side& s : sides_) {
    if (!s.backoff && !s.queue.empty()) s.backoff = random_.below(s.window + 1);
    if (s.backoff) fewest = std::min(fewest, *s.backoff);
  }
  idle_since_ = now + background_.interruptions(occupied + difs + fewest * slot_time, random_);
  for (Side& s : sides_) {
    s.ready = idle_since_ + difs + s.backoff.value_or(0) * slot_time;
    s.backoff.reset();
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
