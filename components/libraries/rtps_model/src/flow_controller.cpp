// SPDX-License-Identifier: Apache-2.0
#include "rtps_model/flow_controller.hpp"

#include <algorithm>
#include <cassert>

namespace tocsin::rtps {
namespace {

std::deque<FlowController::Entry>::iterator find(std::deque<FlowController::Entry>& queue,
                                                 std::size_t writer, Sequence sequence) {
  return std::find_if(queue.begin(), queue.end(), [&](const FlowController::Entry& one) {
    return one.writer == writer && one.sequence == sequence;
  });
}

/// The least that must fit before a sample's turn begins.
std::size_t smallest_piece(const FlowController::Entry& entry) {
  if (entry.fragment_bytes == 0) return entry.bytes;
  const std::size_t last = entry.bytes % entry.fragment_bytes;
  return last == 0 ? entry.fragment_bytes : last;
}

}  // namespace

FlowController::FlowController(const Settings& settings, Time start)
    : settings_(settings), period_begin_(start), budget_{settings.max_bytes_per_period} {
  assert(settings.max_bytes_per_period > 0);
}

std::size_t FlowController::new_queue() {
  queues_.emplace_back();
  return queues_.size() - 1;
}

std::size_t FlowController::add_writer(const Share& share) {
  std::size_t queue = queues_.size();
  for (const Writer& one : writers_) {
    const bool shared =
        settings_.schedule == Schedule::fifo ||
        (settings_.schedule == Schedule::high_priority && one.share.priority == share.priority);
    if (shared) queue = one.queue;
  }
  if (queue == queues_.size()) queue = new_queue();
  const auto percent = static_cast<std::size_t>(share.reservation_percent);
  writers_.push_back({share, queue, settings_.max_bytes_per_period * percent / 100});
  const std::size_t number = writers_.size() - 1;
  const auto place = std::upper_bound(
      by_priority_.begin(), by_priority_.end(), share.priority,
      [this](int wanted, std::size_t one) { return wanted < writers_[one].share.priority; });
  by_priority_.insert(place, number);
  return number;
}

void FlowController::add(const Entry& entry, bool resent) {
  Queue& queue = queues_[writers_[entry.writer].queue];
  for (auto* list : {&queue.fresh, &queue.resent}) {
    if (find(*list, entry.writer, entry.sequence) != list->end()) return;
  }
  (resent ? queue.resent : queue.fresh).push_back(entry);
}

void FlowController::remove(std::size_t writer, Sequence sequence) {
  Queue& queue = queues_[writers_[writer].queue];
  for (auto* list : {&queue.fresh, &queue.resent}) {
    const auto found = find(*list, writer, sequence);
    if (found != list->end()) list->erase(found);
  }
}

void FlowController::begin_period(Time now) {
  if (now < period_begin_ + settings_.period) return;
  period_begin_ += (now - period_begin_) / settings_.period * settings_.period;
  budget_.sent = 0;
  waits_for_period_ = false;
  for (Writer& one : writers_) one.used = 0;
}

bool FlowController::fits(const Entry& entry) const {
  const std::size_t used = budget_.sent + budget_.pending;
  return used < budget_.limit && budget_.limit - used > smallest_piece(entry);
}

void FlowController::run(Time now, const Deliver& deliver) {
  begin_period(now);
  while (!waits_for_period_) {
    const auto choice = choose();
    if (!choice) return;
    waits_for_period_ =
        !fits(queues_[choice->queue].first().front()) || !deliver_next(*choice, deliver);
  }
}

bool FlowController::deliver_next(const Choice& choice, const Deliver& deliver) {
  auto& list = queues_[choice.queue].first();
  const Entry entry = list.front();
  list.pop_front();  // what delivers it may remove others
  if (!deliver(entry, budget_)) {
    list.push_front(entry);
    return false;
  }
  if (settings_.schedule == Schedule::round_robin) turn_ = (turn_ + 1) % queues_.size();
  if (choice.by_reservation) {
    writers_[entry.writer].used += entry.fragment_bytes == 0 ? entry.bytes : entry.fragment_bytes;
  }
  return true;
}

std::optional<FlowController::Choice> FlowController::choose() {
  if (settings_.schedule == Schedule::round_robin) return choose_in_turn();
  if (settings_.schedule == Schedule::priority_with_reservation) return choose_reserved();
  for (const std::size_t writer : by_priority_) {
    const std::size_t queue = writers_[writer].queue;
    if (!queues_[queue].empty()) return Choice{queue, false};
  }
  return std::nullopt;
}

std::optional<FlowController::Choice> FlowController::choose_in_turn() {
  for (std::size_t i = 0; i < queues_.size(); ++i) {
    if (!queues_[turn_].empty()) return Choice{turn_, false};
    turn_ = (turn_ + 1) % queues_.size();
  }
  return std::nullopt;
}

std::optional<FlowController::Choice> FlowController::choose_reserved() {
  std::optional<Choice> most_urgent;
  for (const std::size_t number : by_priority_) {
    const Writer& writer = writers_[number];
    Queue& queue = queues_[writer.queue];
    if (queue.empty()) continue;
    const Entry& entry = queue.first().front();
    const std::size_t size = entry.fragment_bytes == 0 ? entry.bytes : entry.fragment_bytes;
    if (writer.reserved > writer.used + size) return Choice{writer.queue, true};
    if (!most_urgent) most_urgent = Choice{writer.queue, false};
  }
  return most_urgent;
}

Time FlowController::next_event() const {
  const bool any =
      std::any_of(queues_.begin(), queues_.end(), [](const Queue& one) { return !one.empty(); });
  return any ? period_begin_ + settings_.period : never;
}

}  // namespace tocsin::rtps
