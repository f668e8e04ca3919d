// SPDX-License-Identifier: Apache-2.0
#include "link_router/delivery_log.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace tocsin::router {
namespace {

/// Ages of this and more say nothing of the arrival: a receipt codes them in 16 bits of 100 us.
constexpr Duration longest_age = std::chrono::seconds(5);

bool names(const StreamReceipt& receipt, TransmissionNumber number) {
  if (number == receipt.highest) return true;
  if (number > receipt.highest || receipt.highest - number > StreamReceipt::window) return false;
  return (receipt.before >> (receipt.highest - number - 1) & 1U) != 0;
}

bool is_settled(const DeliveryLog::Record& record) {
  return std::all_of(record.copies.begin(), record.copies.end(),
                     [](const DeliveryLog::Copy& copy) { return copy.settled; });
}

}  // namespace

void DeliveryLog::add(const Record& record) {
  Records& records = streams_[record.sample->stream];
  records.push_back(record);
  record.sample->under_way += static_cast<unsigned>(record.copies.size());
  trim(records);
}

void DeliveryLog::trim(Records& records) {
  // No receipt tells of older ones.
  while (records.size() > StreamReceipt::window + 1 && is_settled(records.front())) {
    records.pop_front();
  }
}

void DeliveryLog::take_back(StreamId stream, TransmissionNumber number) {
  const auto found = streams_.find(stream);
  if (found == streams_.end() || found->second.empty()) return;
  const Record& last = found->second.back();
  if (last.number != number) return;
  last.sample->under_way -= static_cast<unsigned>(last.copies.size());
  found->second.pop_back();
}

void DeliveryLog::forget_stream(StreamId stream) { streams_.erase(stream); }

Settlement DeliveryLog::settle(Record& record, Copy& copy, bool came) {
  Settlement settlement;
  settlement.peer = copy.peer;
  settlement.came = came;
  settlement.was_settled = copy.settled;
  settlement.cost = record.cost;
  settlement.sent = record.sent;
  settlement.expected = copy.expected;
  settlement.sample = record.sample;
  if (!copy.settled) --record.sample->under_way;
  copy.settled = true;
  copy.came = came;
  return settlement;
}

std::vector<Settlement> DeliveryLog::forget_peer(PeerIndex peer) {
  std::vector<Settlement> settled;
  for (auto& entry : streams_) {
    for (Record& record : entry.second) {
      for (Copy& copy : record.copies) {
        if (copy.peer == peer && !copy.settled) settled.push_back(settle(record, copy, false));
      }
    }
  }
  return settled;
}

void DeliveryLog::take_stream(PeerIndex peer, const StreamReceipt& receipt, Time made,
                              std::vector<Settlement>& settled) {
  const auto found = streams_.find(receipt.stream);
  if (found == streams_.end()) return;
  for (Record& record : found->second) {
    if (!names(receipt, record.number)) continue;
    for (Copy& copy : record.copies) {
      if (copy.peer != peer || copy.came) continue;
      Settlement one = settle(record, copy, true);
      one.is_exact = record.number == receipt.highest && receipt.age < longest_age;
      one.arrived = one.is_exact ? made - receipt.age : made;
      settled.push_back(std::move(one));
    }
  }
}

void DeliveryLog::give_up_overtaken(PeerIndex peer, const std::vector<Settlement>& came,
                                    std::vector<Settlement>& settled) {
  std::array<Time, priority_count> latest;
  latest.fill(Time::min());
  for (const Settlement& one : came) {
    Time& time = latest[index_of(one.sample->priority)];
    time = std::max(time, one.sent);
  }
  for (auto& entry : streams_) {
    for (Record& record : entry.second) {
      if (record.sent >= latest[index_of(record.sample->priority)]) break;
      for (Copy& copy : record.copies) {
        if (copy.peer == peer && !copy.settled) settled.push_back(settle(record, copy, false));
      }
    }
  }
}

std::vector<Settlement> DeliveryLog::on_receipt(PeerIndex peer, const LinkReceipt& receipt) {
  std::vector<Settlement> settled;
  for (const StreamReceipt& stream : receipt.streams) {
    take_stream(peer, stream, receipt.made, settled);
  }
  std::sort(settled.begin(), settled.end(),
            [](const Settlement& a, const Settlement& b) { return a.sent < b.sent; });
  std::vector<Settlement> lost;
  give_up_overtaken(peer, settled, lost);
  settled.insert(settled.end(), std::make_move_iterator(lost.begin()),
                 std::make_move_iterator(lost.end()));
  return settled;
}

std::vector<Settlement> DeliveryLog::give_up_overdue(Time now) {
  std::vector<Settlement> settled;
  for (auto& entry : streams_) {
    for (Record& record : entry.second) {
      for (Copy& copy : record.copies) {
        if (!copy.settled && now >= copy.expected + patience_) {
          settled.push_back(settle(record, copy, false));
        }
      }
    }
  }
  return settled;
}

Time DeliveryLog::next_overdue() const {
  Time next = never;
  for (const auto& entry : streams_) {
    for (const Record& record : entry.second) {
      for (const Copy& copy : record.copies) {
        if (!copy.settled) next = std::min(next, copy.expected + patience_);
      }
    }
  }
  return next;
}

std::size_t DeliveryLog::under_way(PeerIndex peer, std::size_t packets) const {
  std::size_t count = 0;
  for (const auto& entry : streams_) {
    for (const Record& record : entry.second) {
      if (record.cost.packets < packets) continue;
      for (const Copy& copy : record.copies) {
        if (copy.peer == peer && !copy.settled) ++count;
      }
    }
  }
  return count;
}

}  // namespace tocsin::router
