// SPDX-License-Identifier: Apache-2.0
#include "event_queue.hpp"

#include <algorithm>
#include <utility>

namespace tocsin::simulation {

bool EventQueue::later(const Event& a, const Event& b) {
  return a.time != b.time ? a.time > b.time : a.number > b.number;
}

void EventQueue::at(Time time, Action action) {
  heap_.push_back({time, asked_++, std::move(action)});
  std::push_heap(heap_.begin(), heap_.end(), later);
}

Time EventQueue::next() const { return heap_.empty() ? never : heap_.front().time; }

void EventQueue::run(Time now) {
  while (!heap_.empty() && heap_.front().time <= now) {
    std::pop_heap(heap_.begin(), heap_.end(), later);
    const Action action = std::move(heap_.back().action);
    heap_.pop_back();
    action();
  }
}

}  // namespace tocsin::simulation
