// SPDX-License-Identifier: Apache-2.0
#include "simulation/standing_stop.hpp"

#include <algorithm>
#include <iterator>

namespace tocsin::simulation {

void StandingStop::on_link(bool stands, Time now) {
  received_ = now;
  if (!stands) {
    link_.reset();
  } else if (!link_) {
    link_ = now;
  }
}

void StandingStop::on_writer(const TopicEnd& writer, bool pressed, Time now) {
  if (pressed) {
    writers_.insert({&writer, now});
  } else {
    writers_.erase(&writer);
  }
}

void StandingStop::on_process_ended(const std::string& process) {
  for (auto one = writers_.begin(); one != writers_.end();) {
    const TopicEnd& end = *one->first;
    one = end.host + "/" + end.process == process ? writers_.erase(one) : std::next(one);
  }
}

std::optional<Time> StandingStop::since(Time now) const {
  Time first = never;
  if (link_) first = *link_;
  if (received_) {
    const Time silent = std::max(*received_, listens_since_) + silent_after;
    if (silent <= now) first = std::min(first, silent);
  }
  for (const auto& entry : writers_) first = std::min(first, entry.second);
  if (first == never) return std::nullopt;
  return std::max(first, listens_since_);
}

}  // namespace tocsin::simulation
