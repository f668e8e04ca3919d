// SPDX-License-Identifier: Apache-2.0
// The sessions, batches and confirmations of a BackfillSender.
#include <algorithm>
#include <cmath>
#include <utility>

#include "link_router/backfill_sender.hpp"
#include "link_router/wire_cost.hpp"

namespace tocsin::router {
namespace {

constexpr std::size_t window = 8;
/// What a batch and each of its samples have around the samples' bytes.
constexpr std::size_t batch_head_bytes = 160;
constexpr std::size_t sample_head_bytes = 28;
/// That may follow each other at once.
constexpr double burst_bytes = 3000;
constexpr double trip_weight = 1.0 / 8;
constexpr Duration first_patience = std::chrono::milliseconds(300);
constexpr Duration longest_patience = std::chrono::seconds(2);

std::size_t bytes_of(const sample_log::LogEntry& entry) {
  return entry.bytes.size() + sample_head_bytes;
}

}  // namespace

void BackfillSender::begin_session() {
  end_session();
  in_session_ = true;
  ++session_;
  last_number_ = 0;
  trip_ = Duration::zero();
  repeats_ = 0;
}

void BackfillSender::end_session() {
  in_session_ = false;
  for (const Sent& sent : window_) {
    for (const Order order : sent.orders) {
      const auto item = items_.find(order);
      if (item != items_.end()) set(order, item->second, State::ready);
    }
  }
  window_.clear();
}

BackfillSender::Sent BackfillSender::make_batch() {
  Sent sent;
  sent.batch.session = session_;
  sent.batch.number = ++last_number_;
  sent.batch.stream = items_.at(*ready_.begin()).id.stream;
  std::size_t bytes = batch_head_bytes;
  for (const Order order : ready_) {
    const Item& item = items_.at(order);
    if (item.id.stream != sent.batch.stream) continue;
    bytes += bytes_of(item.content);
    const bool fits = bytes <= static_cast<std::size_t>(params_.backfill_bytes);
    if (!fits && !sent.orders.empty()) {
      bytes -= bytes_of(item.content);
      break;
    }
    sent.orders.push_back(order);
    sent.batch.samples.push_back(item.content);
  }
  sent.wire_bytes = wire_cost(bytes).bytes;
  for (const Order order : sent.orders) set(order, items_.at(order), State::under_way);
  return sent;
}

double BackfillSender::allowance(Time now, double capacity_bytes_per_s) const {
  const double since_s = to_seconds(now - filled_);
  return std::min(bytes_ + params_.backfill_share * capacity_bytes_per_s * since_s, burst_bytes);
}

void BackfillSender::spend(std::size_t bytes, Time now, double capacity_bytes_per_s) {
  bytes_ = allowance(now, capacity_bytes_per_s) - static_cast<double>(bytes);
  filled_ = now;
}

/// Each repetition waits twice as long.
Time BackfillSender::repeat_at() const {
  const auto factor = std::int64_t{1} << std::min(repeats_, 8U);
  const Duration patience = std::min((first_patience + 2 * trip_) * factor, longest_patience);
  return std::max(window_.front().at, progress_) + patience;
}

std::optional<BackfillBatch> BackfillSender::next(Time now, double capacity_bytes_per_s) {
  if (!in_session_ || allowance(now, capacity_bytes_per_s) <= 0) return std::nullopt;
  if (!window_.empty() && now >= repeat_at()) {
    Sent& first = window_.front();
    first.at = now;
    ++repeats_;
    spend(first.wire_bytes, now, capacity_bytes_per_s);
    return first.batch;
  }
  if (window_.size() >= window || ready_.empty()) return std::nullopt;
  window_.push_back(make_batch());
  window_.back().at = now;
  spend(window_.back().wire_bytes, now, capacity_bytes_per_s);
  return window_.back().batch;
}

Time BackfillSender::deadline(Time now, double capacity_bytes_per_s) const {
  if (!in_session_) return never;
  const bool can_go = window_.size() < window && !ready_.empty();
  if (!can_go && window_.empty()) return never;
  Time next = can_go ? now : repeat_at();
  if (!window_.empty()) next = std::min(next, repeat_at());
  const double lacking = -allowance(now, capacity_bytes_per_s);
  if (lacking < 0) return next;
  const double rate = std::max(params_.backfill_share * capacity_bytes_per_s, 1.0);
  return std::max(next, now + seconds((lacking + 1) / rate));
}

std::vector<BackfillSender::SampleId> BackfillSender::on_progress(const BackfillProgress& progress,
                                                                  Time now) {
  std::vector<SampleId> done;
  if (!in_session_ || progress.session != session_) return done;
  while (!window_.empty() && window_.front().batch.number <= progress.number) {
    const Sent& sent = window_.front();
    if (repeats_ == 0) {
      trip_ += seconds(trip_weight * to_seconds(now - sent.at - trip_));
    }
    for (const Order order : sent.orders) {
      const auto item = items_.find(order);
      if (item == items_.end()) continue;  // it crossed live meanwhile
      ++counts_[item->second.id.stream].backfilled;
      done.push_back(item->second.id);
      erase(order);
    }
    window_.pop_front();
    progress_ = now;
    repeats_ = 0;
  }
  return done;
}

}  // namespace tocsin::router
