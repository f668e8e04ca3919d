// SPDX-License-Identifier: Apache-2.0
#include "link_router/backfill_sender.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "link_router/link_constants.hpp"
#include "link_router/wire_cost.hpp"

namespace tocsin::router {
namespace {

/// Read ahead of what is sent.
constexpr std::size_t most_read = 32;
/// Blocked ones that are looked past in one go.
constexpr std::size_t most_looked_at = 256;

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

void BackfillSender::add(Order order, const SampleId& id, State state) {
  orders_[id] = order;
  Item& item = items_[order];
  item.id = id;
  item.state = state;
  if (state == State::live) live_[writer_of(id)].insert(order);
  if (state == State::waiting) {
    waiting_.insert(order);
    ++counts_[id.stream].waiting;
  }
}

void BackfillSender::set(Order order, Item& item, State state) {
  if (item.state == State::live) {
    auto& of_writer = live_[writer_of(item.id)];
    of_writer.erase(order);
    if (of_writer.empty()) live_.erase(writer_of(item.id));
    ++counts_[item.id.stream].waiting;
  }
  if (item.state == State::asked) --asked_;
  waiting_.erase(order);
  ready_.erase(order);
  item.state = state;
  if (state == State::waiting) waiting_.insert(order);
  if (state == State::ready) ready_.insert(order);
  if (state == State::asked) ++asked_;
}

void BackfillSender::erase(Order order) {
  const auto found = items_.find(order);
  Item& item = found->second;
  set(order, item, State::under_way);
  --counts_[item.id.stream].waiting;
  orders_.erase(item.id);
  items_.erase(found);
}

void BackfillSender::offer(const SampleId& id) {
  counts_.try_emplace(id.stream);
  if (orders_.count(id) == 0) add(++last_offered_, id, State::live);
}

void BackfillSender::recover(const SampleId& id) {
  counts_.try_emplace(id.stream);
  if (orders_.count(id) != 0) return;
  add(follows_an_offered(id) ? ++last_offered_ : ++last_recovered_, id, State::waiting);
}

bool BackfillSender::follows_an_offered(const SampleId& id) const {
  const auto next = orders_.lower_bound(id);
  if (next == orders_.begin()) return false;
  const auto& [before, order] = *std::prev(next);
  return writer_of(before) == writer_of(id) && order > first_offered && order <= last_offered_;
}

void BackfillSender::on_logged(const SampleId& id, sample_log::Logged logged) {
  StoredCounts& count = counts_[id.stream];
  if (logged == sample_log::Logged::kept) ++count.stored;
  const auto known = orders_.find(id);
  if (known == orders_.end()) return;
  if (logged == sample_log::Logged::confirmed) return erase(known->second);
  if (logged != sample_log::Logged::refused) return;
  Item& item = items_.at(known->second);
  item.refused = true;
  if (item.state == State::live) return;
  ++count.refused;
  erase(known->second);
}

bool BackfillSender::on_fate(const SampleId& id, LiveFate fate) {
  const auto known = orders_.find(id);
  if (known == orders_.end()) return false;
  const Order order = known->second;
  Item& item = items_.at(order);
  const bool in_log = !item.refused;
  if (fate == LiveFate::delivered) {
    erase(order);
    return in_log;
  }
  if (item.state != State::live) return false;
  if (in_log) {
    set(order, item, State::waiting);
  } else {
    ++counts_[id.stream].refused;
    erase(order);
  }
  return false;
}

bool BackfillSender::on_retired(const SampleId& id) {
  const auto known = orders_.find(id);
  if (known == orders_.end()) return false;
  Item& item = items_.at(known->second);
  if (item.state == State::live) {
    item.refused = true;  // lost only if it does not cross
    return false;
  }
  const bool in_memory = item.state == State::ready || item.state == State::under_way;
  if (in_memory) return false;
  ++counts_[id.stream].expired;
  erase(known->second);
  return true;
}

void BackfillSender::request(const SampleId& id) {
  counts_.try_emplace(id.stream);
  if (orders_.count(id) == 0) add(++last_requested_, id, State::waiting);
}

void BackfillSender::withdraw(const SampleId& id) {
  const auto known = orders_.find(id);
  if (known == orders_.end() || known->second <= first_requested) return;
  if (items_.at(known->second).state != State::under_way) erase(known->second);
}

bool BackfillSender::is_blocked(Order order, const SampleId& id) const {
  const auto live = live_.find(writer_of(id));
  return live != live_.end() && *live->second.begin() < order;
}

std::vector<BackfillSender::SampleId> BackfillSender::take_wanted() {
  std::vector<SampleId> wanted;
  if (!in_session_ || asked_ > 0 || waiting_.empty()) return wanted;
  const auto first = ready_.begin();
  const auto before = std::distance(first, ready_.lower_bound(*waiting_.begin()));
  if (static_cast<std::size_t>(before) > most_read / 2) return wanted;
  std::vector<Order> chosen;
  std::size_t looked_at = 0;
  for (const Order order : waiting_) {
    if (chosen.size() == most_read || ++looked_at > most_looked_at) break;
    if (!is_blocked(order, items_.at(order).id)) chosen.push_back(order);
  }
  for (const Order order : chosen) {
    Item& item = items_.at(order);
    set(order, item, State::asked);
    wanted.push_back(item.id);
  }
  return wanted;
}

void BackfillSender::on_read(const std::vector<SampleId>& asked,
                             std::vector<sample_log::LogEntry> read) {
  for (sample_log::LogEntry& entry : read) {
    const auto known = orders_.find(entry.id);
    if (known == orders_.end()) continue;
    Item& item = items_.at(known->second);
    if (item.state != State::asked) continue;
    item.content = std::move(entry);
    set(known->second, item, State::ready);
  }
  for (const SampleId& id : asked) {
    const auto known = orders_.find(id);
    if (known == orders_.end() || items_.at(known->second).state != State::asked) continue;
    ++counts_[id.stream].refused;
    erase(known->second);
  }
}

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
    const bool fits = bytes <= backfill_bytes;
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
      if (item == items_.end()) continue;  // it was delivered live meanwhile
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
