// SPDX-License-Identifier: Apache-2.0
// What a LinkSender puts on the wire, and when.
#include <algorithm>
#include <cmath>
#include <limits>

#include "link_router/link_sender.hpp"

namespace tocsin::router {
namespace {

constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();
/// Repairs that may follow each other at once.
constexpr double repair_burst_bytes = 4000;
constexpr Duration scale_period = std::chrono::milliseconds(50);

}  // namespace

bool LinkSender::is_silent(Time now) const {
  return !peers_.empty() && std::all_of(peers_.begin(), peers_.end(), [now](const auto& entry) {
    return entry.second.estimator.is_silent(now);
  });
}

const LinkEstimator* LinkSender::slowest_peer(Time now) const {
  const LinkEstimator* slowest = nullptr;
  const bool silent = is_silent(now);
  for (const auto& entry : peers_) {
    const LinkEstimator& one = entry.second.estimator;
    if (!silent && one.is_silent(now)) continue;
    if (slowest == nullptr || one.capacity_bytes_per_s() < slowest->capacity_bytes_per_s()) {
      slowest = &one;
    }
  }
  return slowest;
}

double LinkSender::capacity_bytes_per_s(Time now) const {
  const LinkEstimator* const slowest = slowest_peer(now);
  return slowest == nullptr ? params_.capacity_start_bytes_per_s : slowest->capacity_bytes_per_s();
}

Duration LinkSender::backlog(Time now) const {
  Duration longest{0};
  for (const auto& entry : peers_) {
    const LinkEstimator& estimator = entry.second.estimator;
    if (!estimator.is_silent(now)) longest = std::max(longest, estimator.backlog(now));
  }
  return longest;
}

bool LinkSender::bulk_may_go(Time now) const {
  if (is_silent(now)) return false;
  if (backlog(now) > seconds(params_.bulk_backlog_s)) return false;
  const auto bulk = static_cast<std::size_t>(params_.bulk_packets);
  const auto most = static_cast<std::size_t>(params_.bulk_under_way);
  return std::all_of(peers_.begin(), peers_.end(), [&](const auto& entry) {
    const Peer& peer = entry.second;
    return peer.estimator.is_silent(now) || log_.count_under_way(peer.index, bulk) < most;
  });
}

std::size_t LinkSender::packets_allowed(TrafficClass traffic_class, Time now) const {
  const bool probe_due = sent_at_ == Time::min() || now - sent_at_ >= seconds(params_.repair_max_s);
  if (is_silent(now) && probe_due) return any_number;
  if (bulk_may_go(now)) return any_number;
  const auto small = static_cast<std::size_t>(params_.bulk_packets);
  if (traffic_class <= TrafficClass::high) return small;
  if (is_silent(now) || backlog(now) > seconds(params_.hold_backlog_s)) return 0;
  return small;
}

std::optional<Waiting> LinkSender::take_waiting(TrafficClass traffic_class, Time now) {
  if (queue_.samples(traffic_class) == 0) return std::nullopt;
  return queue_.take_first(traffic_class, packets_allowed(traffic_class, now));
}

std::optional<Transmission> LinkSender::next(Time now) {
  apply(log_.give_up_overdue(now), now);
  count_dropped(queue_.take_expired(now));
  conclude_all(now);
  update_scale(now);
  for (const TrafficClass traffic_class : traffic_classes) {
    if (const auto waiting = take_waiting(traffic_class, now)) {
      ++counts(traffic_class).sent;
      const SentSamplePtr sent = make_sent(*waiting);
      Stream& stream = streams_.at(sent->stream);
      ++stream.counts.sent;
      source_of(stream, sent->sample).sent = now;
      supersede(*sent, stream.rule.depth);
      open_.push_back(sent);
      return transmit(sent, now);
    }
    if (const SentSamplePtr sent = due_repair(traffic_class, now)) return transmit(sent, now);
  }
  return std::nullopt;
}

SentSamplePtr LinkSender::make_sent(const Waiting& waiting) {
  Stream& stream = streams_.at(waiting.stream);
  const auto sent = std::make_shared<SentSample>();
  sent->stream = waiting.stream;
  sent->traffic_class = stream.rule.traffic_class;
  sent->sample = waiting.sample;
  sent->cost = waiting.cost;
  sent->offered = waiting.offered;
  sent->expires = waiting.expires;
  for (const auto& entry : peers_) {
    if (entry.second.wanted.count(waiting.stream) != 0) sent->missing.push_back(entry.second.index);
  }
  if (stream.rule.durable) {
    source_of(stream, sent->sample).newest = sent;
  } else if (sent->expires == never) {
    sent->expires = waiting.offered + seconds(params_.repair_lifespan_s);
  }
  return sent;
}

void LinkSender::supersede(const SentSample& newer, std::size_t depth) {
  for (const SentSamplePtr& older : open_) {
    if (older->stream != newer.stream ||
        older->sample.origin.source != newer.sample.origin.source) {
      continue;
    }
    // What is sent for a peer that came later is the newest one, or it is none.
    older->superseded = ++older->newer >= (older->counted ? depth : 1);
  }
}

Duration LinkSender::repair_wait(const SentSample& sent, Duration expected) const {
  const double growth = std::pow(params_.repair_backoff, sent.transmissions - 1);
  return expected + seconds(std::min(params_.repair_first_s * growth, params_.repair_max_s));
}

Transmission LinkSender::transmit(const SentSamplePtr& sent, Time now) {
  Stream& stream = streams_.at(sent->stream);
  const WireCost& cost = sent->cost;
  unwritten_ = {0, now, cost, sent, {}};
  Duration expected{0};
  for (auto& entry : peers_) {
    Peer& peer = entry.second;
    if (peer.wanted.count(sent->stream) == 0) continue;
    const Duration wait = std::min(peer.estimator.backlog(now), peer.estimator.expected_delay());
    expected = std::max(expected, wait);
    const Time drained = peer.estimator.on_sent(cost, now);
    unwritten_.copies.push_back({peer.index, drained, false, false});
  }
  const bool repair = sent->transmissions > 0;
  if (!repair) sent->first_sent = now;
  ++sent->transmissions;
  sent->repair_at = now + repair_wait(*sent, expected);
  ClassCounts& count = counts(sent->traffic_class);
  sent_at_ = now;
  if (stream.fills_in) return {sent->stream, sent->sample, false};
  if (!stream.rule.adaptive) others_.add(cost.bytes, now);
  if (repair || !sent->counted) {
    ++count.repairs;
    repairs_.add(cost.bytes, now);
    repair_bytes_ = repair_allowance(now) - static_cast<double>(cost.bytes);
    repair_filled_ = now;
  }
  return {sent->stream, sent->sample, repair};
}

void LinkSender::on_written(TransmissionNumber number) {
  unwritten_.number = number;
  log_.add(unwritten_);
}

double LinkSender::repair_allowance(Time now) const {
  const double since_s = to_seconds(now - repair_filled_);
  return std::min(repair_bytes_ + params_.repair_share * capacity_bytes_per_s(now) * since_s,
                  repair_burst_bytes);
}

bool LinkSender::can_repair(const SentSample& sample, Time now) const {
  if (sample.missing.empty() || sample.superseded || now > sample.expires) return false;
  return !sample.counted || streams_.at(sample.stream).rule.repaired;
}

bool LinkSender::may_repair(const SentSample& sample, Time now) const {
  return can_repair(sample, now) && !is_paused(streams_.at(sample.stream).rule);
}

SentSamplePtr LinkSender::due_repair(TrafficClass traffic_class, Time now) {
  if (open_.empty() || repair_allowance(now) <= 0) return nullptr;
  if (is_silent(now) && now - sent_at_ < seconds(params_.repair_first_s)) return nullptr;
  SentSamplePtr due;
  for (const SentSamplePtr& sent : open_) {
    if (sent->traffic_class != traffic_class || sent->repair_at > now || !may_repair(*sent, now))
      continue;
    if (!due || sent->repair_at < due->repair_at) due = sent;
  }
  return due;
}

Time LinkSender::deadline(Time now) const {
  Time next = std::min(queue_.next_expiry(), log_.next_overdue());
  for (const SentSamplePtr& sent : open_) {
    if (!can_repair(*sent, now)) continue;
    if (sent->expires != never) next = std::min(next, sent->expires + Duration{1});
    if (may_repair(*sent, now)) next = std::min(next, std::max(sent->repair_at, repair_ready(now)));
  }
  const bool waits = std::any_of(traffic_classes.begin(), traffic_classes.end(),
                                 [this](TrafficClass p) { return queue_.samples(p) > 0; });
  if (!waits) return next;
  const Time opens = gate_opens(now);
  return opens > now ? std::min(next, opens) : next;
}

Time LinkSender::gate_opens(Time now) const {
  if (is_silent(now)) return sent_at_ + seconds(params_.repair_max_s);
  const Duration full = backlog(now);
  const Duration hold = seconds(params_.hold_backlog_s);
  return now + full - (full > hold ? hold : seconds(params_.bulk_backlog_s));
}

Time LinkSender::repair_ready(Time now) const {
  Time ready = now;
  const double lacking = -repair_allowance(now);
  if (lacking >= 0) {
    const double rate_bytes_per_s = std::max(params_.repair_share * capacity_bytes_per_s(now), 1.0);
    ready = now + seconds((lacking + 1) / rate_bytes_per_s);
  }
  if (is_silent(now)) ready = std::max(ready, sent_at_ + seconds(params_.repair_first_s));
  return ready;
}

void LinkSender::update_scale(Time now) {
  if (scale_updated_ != Time::min() && now - scale_updated_ < scale_period) return;
  scale_updated_ = now;
  AdaptiveScale::Input input;
  input.capacity_bytes_per_s = capacity_bytes_per_s(now);
  input.others_bytes_per_s = others_.bytes_per_s(now);
  for (const auto& entry : streams_) input.nominal_bytes_per_s += entry.second.peak_bytes_per_s;
  input.silent = is_silent(now);
  scale_.update(input, now);
}

}  // namespace tocsin::router
