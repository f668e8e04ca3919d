// SPDX-License-Identifier: Apache-2.0
// What a reliable writer does when readers come, go and speak.
#include <algorithm>

#include "rtps_model/reliable_writer.hpp"

namespace tocsin::rtps {

void ReliableWriter::match(EndId reader, Time now) {
  forget_expired(now);
  readers_.push_back({ReaderProxy(reader, first() - 1)});
  MessageGroup group(sender_);
  group.address({reader});
  if (!history_.empty()) {
    if (settings_.transient_local) {
      for (const SamplePtr& one : history_) {
        readers_.back().proxy.add(one, ReaderProxy::Status::unacknowledged);
      }
    } else {
      group.add(Gap{first(), last_ + 1, {}});
    }
    ask_for_heartbeat(now);
  }
  add_heartbeat(group);
}

void ReliableWriter::unmatch(EndId reader, Time now) {
  const auto found = std::find_if(readers_.begin(), readers_.end(), [reader](const Reader& one) {
    return one.proxy.reader() == reader;
  });
  if (found == readers_.end()) return;
  readers_.erase(found);
  forget_expired(now);
  if (readers_.empty()) heartbeat_at_ = never;
  check_acknowledged();
}

void ReliableWriter::on_message(EndId from, const Message& message, Time now) {
  Reader* reader = reader_of(from);
  if (reader == nullptr) return;
  forget_expired(now);
  for (const Submessage& part : message.parts) {
    if (const auto* acknack = std::get_if<AckNack>(&part)) on_acknack(*reader, *acknack, now);
    if (const auto* nack = std::get_if<NackFrag>(&part)) on_nack_frag(*reader, *nack, now);
  }
  if (answer_at_ <= now) answer(now);
}

void ReliableWriter::on_acknack(Reader& reader, const AckNack& acknack, Time now) {
  if (acknack.count <= reader.acknack_count) return;
  reader.acknack_count = acknack.count;
  if (acknack.base == 0) {
    on_first_acknack(reader, now);
  } else {
    reader.proxy.acknowledge_before(acknack.base);
    std::vector<Sequence> absent;
    const bool any = !history_.empty() && reader.proxy.request(acknack.missing, first(), absent);
    if (any) {
      ask_for_answer(now);
    } else if (!acknack.missing.empty()) {
      ask_for_heartbeat(now);
    }
    if (!absent.empty()) {
      MessageGroup group(sender_);
      group.address({reader.proxy.reader()});
      group.add(gap_of(absent));
    }
  }
  check_acknowledged();
}

void ReliableWriter::on_first_acknack(Reader& reader, Time now) {
  if (settings_.transient_local) reader.proxy.start_over(history_);
  MessageGroup group(sender_);
  group.address({reader.proxy.reader()});
  add_heartbeat(group);
  ask_for_heartbeat(now);
}

void ReliableWriter::on_nack_frag(Reader& reader, const NackFrag& nack, Time now) {
  if (nack.count <= reader.nack_frag_count) return;
  reader.nack_frag_count = nack.count;
  if (reader.proxy.request(nack.sequence, nack.missing)) ask_for_answer(now);
}

void ReliableWriter::ask_for_answer(Time now) {
  if (answer_at_ == never) answer_at_ = now + settings_.nack_response_delay;
}

void ReliableWriter::answer(Time now) {
  answer_at_ = never;
  for (Reader& one : readers_) {
    std::vector<Sequence> requested;
    one.proxy.answer(requested);
    for (const Sequence sequence : requested) send(sequence, true);
  }
  deliver_due(now);
}

void ReliableWriter::end_suppression(Time now) {
  for (Reader& one : readers_) {
    if (one.suppressed_until > now) continue;
    one.suppressed_until = never;
    one.proxy.end_suppression();
    ask_for_heartbeat(now);
  }
}

}  // namespace tocsin::rtps
