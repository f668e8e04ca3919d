// SPDX-License-Identifier: Apache-2.0
#include "link_router/delivery_log.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

namespace tocsin::router {
namespace {

/// Ages of this and more say nothing of the arrival: an acknowledgement codes them in 16 bits of
/// 100 us.
constexpr Duration longest_age = std::chrono::seconds(5);
/// How much later than expected a piece may arrive behind one that was received: a frame's
/// retransmissions on the air.
constexpr Duration tail_patience = std::chrono::milliseconds(40);

bool names(const StreamAcknowledgement& acknowledgement, TransmissionNumber number) {
  if (number == acknowledgement.highest) return true;
  if (number > acknowledgement.highest ||
      acknowledgement.highest - number > StreamAcknowledgement::window)
    return false;
  return (acknowledgement.before >> (acknowledgement.highest - number - 1) & 1U) != 0;
}

bool is_acknowledged(const DeliveryLog::Record& record) {
  return std::all_of(record.copies.begin(), record.copies.end(),
                     [](const DeliveryLog::Copy& copy) { return copy.received; });
}

bool is_settled(const DeliveryLog::Record& record) {
  return std::all_of(record.copies.begin(), record.copies.end(),
                     [](const DeliveryLog::Copy& copy) { return copy.settled; });
}

}  // namespace

void DeliveryLog::add(Record record) {
  const auto kept = std::make_shared<Record>(std::move(record));
  kept->order = ++last_order_;
  Records& records = streams_[{kept->sample->stream, kept->path}];
  records.push_back(kept);
  kept->sample->under_way += static_cast<unsigned>(kept->copies.size());
  if (!kept->copies.empty()) under_way_.push_back(kept);
  // No acknowledgement names older ones.
  if (records.size() > StreamAcknowledgement::window + 1) records.pop_front();
}

void DeliveryLog::forget_stream(StreamId stream) {
  for (PathIndex path = 0; path < most_paths; ++path) streams_.erase({stream, path});
  for (auto it = highest_.begin(); it != highest_.end();) {
    it = it->first.first.first == stream ? highest_.erase(it) : std::next(it);
  }
  under_way_.erase(std::remove_if(under_way_.begin(), under_way_.end(),
                                  [stream](const RecordPtr& record) {
                                    return record->sample->stream == stream;
                                  }),
                   under_way_.end());
}

void DeliveryLog::drop_settled() {
  under_way_.erase(std::remove_if(under_way_.begin(), under_way_.end(),
                                  [](const RecordPtr& record) { return is_settled(*record); }),
                   under_way_.end());
}

template <class Ends>
void DeliveryLog::give_up(Ends ends, std::vector<Settlement>& settled) {
  bool any = false;
  for (const RecordPtr& record : under_way_) {
    for (Copy& copy : record->copies) {
      if (copy.settled || !ends(*record, copy)) continue;
      settled.push_back(settle(*record, copy, false));
      any = true;
    }
  }
  if (any) drop_settled();
}

Settlement DeliveryLog::settle(Record& record, Copy& copy, bool received) {
  Settlement settlement;
  settlement.peer = copy.peer;
  settlement.path = record.path;
  settlement.received = received;
  settlement.cost = record.cost;
  settlement.burst = record.burst;
  settlement.order = record.order;
  settlement.sent = record.sent;
  settlement.expected = copy.expected;
  settlement.sample = record.sample;
  if (!copy.settled) --record.sample->under_way;
  copy.settled = true;
  copy.received = received;
  return settlement;
}

std::vector<Settlement> DeliveryLog::forget_peer(PeerIndex peer) {
  std::vector<Settlement> settled;
  give_up([peer](const Record&, const Copy& copy) { return copy.peer == peer; }, settled);
  return settled;
}

Settlement DeliveryLog::receive(Record& record, Copy& copy,
                                const StreamAcknowledgement& acknowledgement, Time made) {
  Settlement one = settle(record, copy, true);
  one.is_exact = record.number == acknowledgement.highest && acknowledgement.age < longest_age;
  one.arrived = one.is_exact ? made - acknowledgement.age : made;
  if (one.is_exact)
    highest_[{{acknowledgement.stream, record.path}, copy.peer}] = {record.number, copy.expected};
  return one;
}

void DeliveryLog::take_stream(PeerIndex peer, const StreamAcknowledgement& acknowledgement,
                              Time made, std::vector<Settlement>& settled) {
  const auto found = streams_.find({acknowledgement.stream, acknowledgement.path});
  if (found == streams_.end()) return;
  Records& records = found->second;
  for (const RecordPtr& record : records) {
    if (!names(acknowledgement, record->number)) continue;
    for (Copy& copy : record->copies) {
      if (copy.peer != peer || copy.received) continue;
      settled.push_back(receive(*record, copy, acknowledgement, made));
    }
  }
  // No later acknowledgement changes what every peer has acknowledged.
  records.erase(std::remove_if(records.begin(), records.end(),
                               [](const RecordPtr& record) { return is_acknowledged(*record); }),
                records.end());
}

void DeliveryLog::give_up_tail(PeerIndex peer, const StreamAcknowledgement& acknowledgement,
                               std::vector<Settlement>& lost) {
  const auto found = highest_.find({{acknowledgement.stream, acknowledgement.path}, peer});
  if (found == highest_.end() || found->second.number != acknowledgement.highest ||
      acknowledgement.age >= longest_age) {
    return;
  }
  const Time latest = found->second.expected + (acknowledgement.age - tail_patience);
  give_up(
      [&](const Record& record, const Copy& copy) {
        return copy.peer == peer && record.sample->mends_with_bulk() &&
               record.sample->stream == acknowledgement.stream &&
               record.path == acknowledgement.path && record.number > acknowledgement.highest &&
               copy.expected < latest;
      },
      lost);
}

void DeliveryLog::give_up_overtaken(PeerIndex peer, const std::vector<Settlement>& received,
                                    std::vector<Settlement>& settled) {
  std::array<std::array<std::uint64_t, traffic_classes.size()>, most_paths> latest{};
  for (const Settlement& one : received) {
    std::uint64_t& order = latest[one.path][index_of(one.sample->traffic_class)];
    order = std::max(order, one.order);
  }
  give_up(
      [&](const Record& record, const Copy& copy) {
        return copy.peer == peer &&
               record.order < latest[record.path][index_of(record.sample->traffic_class)];
      },
      settled);
}

std::vector<Settlement> DeliveryLog::on_acknowledgement(
    PeerIndex peer, const LinkAcknowledgement& acknowledgement) {
  std::vector<Settlement> settled;
  for (const StreamAcknowledgement& stream : acknowledgement.streams) {
    take_stream(peer, stream, acknowledgement.made, settled);
  }
  std::sort(settled.begin(), settled.end(),
            [](const Settlement& a, const Settlement& b) { return a.order < b.order; });
  if (!settled.empty()) drop_settled();
  std::vector<Settlement> lost;
  give_up_overtaken(peer, settled, lost);
  for (const StreamAcknowledgement& stream : acknowledgement.streams) {
    give_up_tail(peer, stream, lost);
  }
  settled.insert(settled.end(), std::make_move_iterator(lost.begin()),
                 std::make_move_iterator(lost.end()));
  return settled;
}

std::vector<Settlement> DeliveryLog::give_up_overdue(Time now) {
  std::vector<Settlement> settled;
  give_up([&](const Record&, const Copy& copy) { return now >= copy.expected + patience_; },
          settled);
  return settled;
}

Time DeliveryLog::next_overdue() const {
  Time next = never;
  for (const RecordPtr& record : under_way_) {
    for (const Copy& copy : record->copies) {
      if (!copy.settled) next = std::min(next, copy.expected + patience_);
    }
  }
  return next;
}

bool DeliveryLog::is_under_way(PeerIndex peer, PathIndex path) const {
  return std::any_of(under_way_.begin(), under_way_.end(), [&](const RecordPtr& record) {
    return record->path == path &&
           std::any_of(record->copies.begin(), record->copies.end(),
                       [peer](const Copy& copy) { return copy.peer == peer && !copy.settled; });
  });
}

std::size_t DeliveryLog::count_under_way(PeerIndex peer, PathIndex path,
                                         std::size_t packets) const {
  std::size_t divided = 0;
  std::size_t whole = 0;
  for (const RecordPtr& record : under_way_) {
    if (record->path != path || record->cost.packets < packets ||
        !record->sample->piece.is_last()) {
      continue;
    }
    for (const Copy& copy : record->copies) {
      if (copy.peer == peer && !copy.settled) ++(record->sample->whole ? divided : whole);
    }
  }
  return divided + (whole > 0 ? whole - 1 : 0);
}

}  // namespace tocsin::router
