// SPDX-License-Identifier: Apache-2.0
// What is stored and what became of it; what is sent is in backfill_window.cpp.
#include "link_router/backfill_sender.hpp"

#include <iterator>

namespace tocsin::router {
namespace {

/// Read ahead of what is sent.
constexpr std::size_t most_read = 32;
/// Blocked ones that are looked past in one go.
constexpr std::size_t most_looked_at = 256;

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
  (void)counts_[id.stream];
  if (orders_.count(id) == 0) add(++last_offered_, id, State::live);
}

void BackfillSender::recover(const SampleId& id) {
  (void)counts_[id.stream];
  if (orders_.count(id) == 0) add(++last_recovered_, id, State::waiting);
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
  if (fate == LiveFate::crossed) {
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
  (void)counts_[id.stream];
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

}  // namespace tocsin::router
