// SPDX-License-Identifier: Apache-2.0
#include "messages.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace tocsin::experiment {
namespace {

using report::Arrival;

bool by_writer(const Arrival& a, const Arrival& b) {
  return std::tie(a.topic, a.writer, a.sequence) < std::tie(b.topic, b.writer, b.sequence);
}

bool same_writer(const Arrival& a, const Arrival& b) {
  return a.writer == b.writer && a.topic == b.topic;
}

/// The samples missing between two neighbours.
void add_lost(const Arrival& before, const Arrival& after, std::vector<Message>& messages) {
  if (after.sequence <= before.sequence + 1) return;
  const auto steps = static_cast<double>(after.sequence - before.sequence);
  const double step_s = (after.sent_s - before.sent_s) / steps;
  for (std::uint64_t i = 1; i < after.sequence - before.sequence; ++i) {
    messages.push_back({before.sent_s + static_cast<double>(i) * step_s, std::nan(""),
                        after.topic == camera_topic});
  }
}

}  // namespace

std::vector<Message> messages_of(std::vector<Arrival> arrivals, double begin_s, double end_s) {
  std::sort(arrivals.begin(), arrivals.end(), by_writer);
  std::vector<Message> messages;
  for (std::size_t i = 0; i < arrivals.size(); ++i) {
    const Arrival& one = arrivals[i];
    if (i > 0 && same_writer(arrivals[i - 1], one)) add_lost(arrivals[i - 1], one, messages);
    messages.push_back(
        {one.sent_s, std::max(0.0, one.received_s - one.sent_s), one.topic == camera_topic});
  }
  const auto outside = [&](const Message& m) { return m.sent_s < begin_s || m.sent_s >= end_s; };
  messages.erase(std::remove_if(messages.begin(), messages.end(), outside), messages.end());
  return messages;
}

}  // namespace tocsin::experiment
