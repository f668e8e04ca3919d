// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_queue.hpp"

#include <algorithm>
#include <utility>

namespace tocsin::router {
namespace {

bool same_source(const Waiting& a, const Waiting& b) {
  return a.stream == b.stream && a.sample.origin.source == b.sample.origin.source;
}

}  // namespace

std::optional<Dropped> LinkQueue::replace(Class& in, std::size_t depth, const Waiting& waiting) {
  const auto same = [&](const Waiting& other) { return same_source(other, waiting); };
  const auto count =
      static_cast<std::size_t>(std::count_if(in.waiting.begin(), in.waiting.end(), same));
  if (count < depth) {
    in.waiting.push_back(waiting);
    in.bytes += waiting.sample.bytes;
    return std::nullopt;
  }
  // Each takes the turn of the one before it, so that the oldest goes and the order stays.
  auto place = std::find_if(in.waiting.begin(), in.waiting.end(), same);
  Dropped oldest{*place, DropReason::superseded};
  in.bytes += waiting.sample.bytes - oldest.waiting.sample.bytes;
  for (auto next = place;;) {
    next = std::find_if(std::next(next), in.waiting.end(), same);
    if (next == in.waiting.end()) break;
    *place = *next;
    place = next;
  }
  *place = waiting;
  return oldest;
}

std::vector<Dropped> LinkQueue::add(TrafficClass traffic_class, std::size_t depth,
                                    const Waiting& waiting) {
  Class& in = classes_[index_of(traffic_class)];
  std::vector<Dropped> dropped;
  if (auto replaced = replace(in, depth, waiting)) dropped.push_back(std::move(*replaced));
  while (in.bytes > class_bytes_ && in.waiting.size() > 1) {
    // The new one stands before the oldest when it took a turn; it is not the one to go.
    const bool is_new = same_source(in.waiting.front(), waiting) &&
                        in.waiting.front().sample.origin.sequence == waiting.sample.origin.sequence;
    dropped.push_back(
        {take(in, std::next(in.waiting.begin(), is_new ? 1 : 0)), DropReason::overflow});
  }
  return dropped;
}

Waiting LinkQueue::take(Class& from, Place place) {
  Waiting taken = *place;
  from.bytes -= taken.sample.bytes;
  from.waiting.erase(place);
  return taken;
}

std::vector<Dropped> LinkQueue::take_expired(Time now) {
  std::vector<Dropped> dropped;
  for (Class& in : classes_) {
    for (auto it = in.waiting.begin(); it != in.waiting.end();) {
      const auto place = it++;
      if (now > place->expires) dropped.push_back({take(in, place), DropReason::expired});
    }
  }
  return dropped;
}

LinkQueue::Place LinkQueue::find_first(const Class& in, std::size_t packets) {
  for (auto one = in.waiting.begin(); one != in.waiting.end(); ++one) {
    if (one->cost.packets >= packets) continue;
    // A source's samples go in their order, also when the first one has to wait.
    const auto is_older = [&](const Waiting& other) { return same_source(other, *one); };
    if (std::none_of(in.waiting.begin(), one, is_older)) return one;
  }
  return in.waiting.end();
}

std::optional<Waiting> LinkQueue::take_first(TrafficClass traffic_class, std::size_t packets) {
  Class& in = classes_[index_of(traffic_class)];
  const Place place = find_first(in, packets);
  if (place == in.waiting.end()) return std::nullopt;
  return take(in, place);
}

std::vector<Waiting> LinkQueue::take_stream(StreamId stream) {
  std::vector<Waiting> taken;
  for (Class& in : classes_) {
    for (auto it = in.waiting.begin(); it != in.waiting.end();) {
      const auto place = it++;
      if (place->stream == stream) taken.push_back(take(in, place));
    }
  }
  return taken;
}

bool LinkQueue::has(StreamId stream) const {
  return std::any_of(classes_.begin(), classes_.end(), [stream](const Class& in) {
    return std::any_of(in.waiting.begin(), in.waiting.end(),
                       [stream](const Waiting& one) { return one.stream == stream; });
  });
}

Time LinkQueue::next_expiry() const {
  Time next = never;
  for (const Class& in : classes_) {
    for (const Waiting& one : in.waiting) {
      if (one.expires != never) next = std::min(next, one.expires + Duration{1});
    }
  }
  return next;
}

}  // namespace tocsin::router
