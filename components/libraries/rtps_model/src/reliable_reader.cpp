// SPDX-License-Identifier: Apache-2.0
#include "rtps_model/reliable_reader.hpp"

#include <algorithm>
#include <utility>

namespace tocsin::rtps {

using Taken = ReaderHistory::Taken;

ReliableReader::ReliableReader(const ReaderSettings& settings, Sender& sender, Deliver deliver)
    : settings_(settings), sender_(sender), deliver_(std::move(deliver)), history_(settings) {}

void ReliableReader::match(EndId writer, Time now) {
  writers_[writer] = {};
  writers_[writer].call_at = now + settings_.initial_acknack_delay;
}

void ReliableReader::unmatch(EndId writer) {
  writers_.erase(writer);
  history_.forget(writer);
}

void ReliableReader::on_message(EndId id, const Message& message, Time now) {
  const auto found = writers_.find(id);
  if (found == writers_.end()) return;
  Writer& writer = found->second;
  for (const Submessage& part : message.parts) {
    if (const auto* data = std::get_if<Data>(&part)) {
      data->fragment == 0 ? on_data(id, writer, *data) : on_piece(id, writer, *data);
    } else if (const auto* heartbeat = std::get_if<Heartbeat>(&part)) {
      on_heartbeat(id, writer, *heartbeat, now);
    } else if (const auto* gap = std::get_if<Gap>(&part)) {
      on_gap(id, writer, *gap);
    }
  }
  if (writer.answer_at <= now) answer(id, writer);
}

void ReliableReader::on_data(EndId id, Writer& writer, const Data& data) {
  const Sequence sequence = data.sample->sequence;
  if (writer.proxy.has(sequence)) return;
  const auto added = history_.add(id, data, writer.proxy.missing_before(sequence));
  settle_dropped(added.dropped);
  if (added.taken != Taken::rejected) writer.proxy.settle(sequence);
  give(id, writer);
}

void ReliableReader::on_piece(EndId id, Writer& writer, const Data& data) {
  const Sequence sequence = data.sample->sequence;
  if (writer.proxy.has(sequence)) return;
  if (history_.has({id, sequence})) {
    if (history_.add_piece(id, data)) writer.proxy.settle(sequence);
  } else {
    const auto added = history_.add(id, data, writer.proxy.missing_before(sequence));
    settle_dropped(added.dropped);
    if (added.taken == Taken::too_old) writer.proxy.settle(sequence);
  }
  give(id, writer);
}

void ReliableReader::settle_dropped(const std::vector<ReaderHistory::Key>& dropped) {
  for (const ReaderHistory::Key& key : dropped) {
    const auto found = writers_.find(key.writer);
    if (found != writers_.end()) found->second.proxy.settle(key.sequence);
  }
}

void ReliableReader::on_heartbeat(EndId id, Writer& writer, const Heartbeat& heartbeat, Time now) {
  if (heartbeat.count <= writer.heartbeats) return;
  writer.heartbeats = heartbeat.count;
  writer.proxy.on_history(heartbeat.first, heartbeat.last);
  history_.drop_pieces_before(id, heartbeat.first);
  if (writer.answer_at == never) writer.answer_at = now + settings_.heartbeat_response_delay;
  give(id, writer);
}

void ReliableReader::on_gap(EndId id, Writer& writer, const Gap& gap) {
  for (Sequence sequence = gap.first; sequence < gap.end; ++sequence) {
    settle_gone(id, writer, sequence);
  }
  for (const Sequence sequence : gap.others) settle_gone(id, writer, sequence);
  give(id, writer);
}

void ReliableReader::settle_gone(EndId id, Writer& writer, Sequence sequence) {
  if (writer.proxy.settle(sequence)) history_.drop_pieces_of({id, sequence});
}

void ReliableReader::give(EndId id, const Writer& writer) {
  for (const SamplePtr& sample : history_.take(id, writer.proxy.available())) deliver_(id, sample);
}

void ReliableReader::answer(EndId id, Writer& writer) {
  writer.answer_at = never;
  MessageGroup group(sender_);
  group.address({id});
  AckNack acknack{writer.proxy.available() + 1, {}, 0};
  for (const Sequence sequence : writer.proxy.missing()) {
    if (!history_.has({id, sequence})) {
      acknack.missing.push_back(sequence);
      continue;
    }
    group.add(NackFrag{sequence, history_.missing_pieces({id, sequence}), ++writer.nack_frags});
  }
  acknack.count = ++writer.acknacks;
  group.add(acknack);
}

void ReliableReader::call(EndId id, Writer& writer, Time now) {
  writer.call_at = never;
  if (writer.heartbeats > 0) return;
  MessageGroup group(sender_);
  group.address({id});
  group.add(AckNack{0, {}, ++writer.acknacks});
  writer.call_at = now + settings_.initial_acknack_delay;
}

Time ReliableReader::next_event() const {
  Time next = never;
  for (const auto& [id, writer] : writers_) {
    next = std::min({next, writer.answer_at, writer.call_at});
  }
  return next;
}

void ReliableReader::on_time(Time now) {
  for (auto& [id, writer] : writers_) {
    if (writer.answer_at <= now) answer(id, writer);
    if (writer.call_at <= now) call(id, writer, now);
  }
}

}  // namespace tocsin::rtps
