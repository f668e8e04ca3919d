// SPDX-License-Identifier: Apache-2.0
#include "held_arrivals.hpp"

#include <algorithm>
#include <iterator>

namespace tocsin {
namespace {

/// For a topic that nobody reads; meanwhile the peer takes its samples for lost.
constexpr Duration longest_hold = std::chrono::seconds(2);
/// Of one flow.
constexpr std::size_t most_held = 64;

}  // namespace

void HeldArrivals::expect(FlowId flow, Time now) {
  flows_.insert_or_assign(flow, Waiting{{longest_hold, now}});
}

void HeldArrivals::on_reader(FlowId flow, Time now) {
  const auto found = flows_.find(flow);
  if (found != flows_.end()) found->second.wait.on_reader(now);
}

bool HeldArrivals::hold(const link_event::LinkSample& sample) {
  const auto found = flows_.find(sample.flow);
  if (found == flows_.end()) return false;
  if (found->second.samples.size() < most_held) found->second.samples.push_back(sample);
  return true;
}

std::vector<link_event::LinkSample> HeldArrivals::take(Time now) {
  std::vector<link_event::LinkSample> due;
  for (auto it = flows_.begin(); it != flows_.end();) {
    if (!it->second.wait.is_over(now)) {
      ++it;
      continue;
    }
    auto& samples = it->second.samples;
    std::move(samples.begin(), samples.end(), std::back_inserter(due));
    it = flows_.erase(it);
  }
  return due;
}

Time HeldArrivals::deadline() const {
  Time next = never;
  for (const auto& entry : flows_) next = std::min(next, entry.second.wait.end());
  return next;
}

}  // namespace tocsin
