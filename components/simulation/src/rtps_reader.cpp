// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "rtps.hpp"

namespace tocsin::simulation {

void RtpsReader::on_data(std::uint64_t source, const Change& change, Time now) {
  Source& from = sources_[source];
  if (!alive_ || change.sequence < from.next) return;
  if (!qos_.reliable()) {
    from.next = change.sequence + 1;
    return give(source, change, now);
  }
  if (change.sequence == from.next && from.early.empty()) {
    ++from.next;
    return give(source, change, now);
  }
  from.early.emplace(change.sequence, change);
  release(source, from, now);
}

std::vector<std::uint64_t> RtpsReader::on_heartbeat(std::uint64_t source, std::uint64_t first,
                                                    std::uint64_t last, Time now) {
  if (!alive_) return {};
  Source& from = sources_[source];
  while (from.next < first) {
    const auto found = from.early.find(from.next++);
    if (found == from.early.end()) continue;
    if (found->second.message) give(source, found->second, now);
    from.early.erase(found);
  }
  release(source, from, now);
  std::vector<std::uint64_t> missing;
  for (std::uint64_t i = from.next; i <= last; ++i) {
    if (from.early.count(i) == 0) missing.push_back(i);
  }
  return missing;
}

void RtpsReader::on_gap(std::uint64_t source, std::uint64_t sequence, Time now) {
  Source& from = sources_[source];
  if (!alive_ || sequence < from.next) return;
  from.early.emplace(sequence, Change{sequence, now, nullptr, 0, nullptr, 0, now, 0});
  release(source, from, now);
}

void RtpsReader::release(std::uint64_t id, Source& source, Time now) {
  while (!source.early.empty() && source.early.begin()->first == source.next) {
    const Change change = std::move(source.early.begin()->second);
    source.early.erase(source.early.begin());
    ++source.next;
    if (change.message) give(id, change, now);
  }
}

void RtpsReader::give(std::uint64_t id, const Change& change, Time now) {
  if (now - change.sent <= seconds(qos_.lifespan_s)) deliver_(change, id);
}

}  // namespace tocsin::simulation
