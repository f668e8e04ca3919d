// SPDX-License-Identifier: Apache-2.0
#include "rtps_model/reliable_writer.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace tocsin::rtps {

using Status = ReaderProxy::Status;

ReliableWriter::ReliableWriter(const WriterSettings& settings, Sender& sender, SampleQueue* queue)
    : settings_(settings), sender_(sender), queue_(queue) {}

Sequence ReliableWriter::first() const {
  return history_.empty() ? last_ + 1 : history_.front()->sequence;
}

std::vector<EndId> ReliableWriter::all_readers() const {
  std::vector<EndId> all;
  all.reserve(readers_.size());
  for (const Reader& one : readers_) all.push_back(one.proxy.reader());
  return all;
}

ReliableWriter::Reader* ReliableWriter::reader_of(EndId reader) {
  const auto found = std::find_if(readers_.begin(), readers_.end(), [reader](const Reader& one) {
    return one.proxy.reader() == reader;
  });
  return found == readers_.end() ? nullptr : &*found;
}

SamplePtr ReliableWriter::find(Sequence sequence) const {
  // Samples leave in the order in which they came, so that the history has no holes.
  if (sequence < first() || sequence > last_) return nullptr;
  return history_[sequence - first()];
}

// History.

void ReliableWriter::forget_expired(Time now) {
  while (!history_.empty() && now - history_.front()->written > settings_.lifespan) remove_first();
}

void ReliableWriter::remove_first() {
  const Sequence sequence = history_.front()->sequence;
  history_.pop_front();
  if (queue_ != nullptr) queue_->remove(sequence);
  for (Reader& one : readers_) one.proxy.remove(sequence);
}

void ReliableWriter::clear() {
  while (!history_.empty()) remove_first();
}

void ReliableWriter::check_acknowledged() {
  Sequence low = last_;
  bool waiting = false;
  for (const Reader& one : readers_) {
    low = std::min(low, one.proxy.low_mark());
    waiting |= one.proxy.waits();
  }
  all_acknowledged_ = std::max(all_acknowledged_, waiting ? low : last_);
  if (settings_.transient_local) return;
  while (!history_.empty() && first() <= low) remove_first();
}

bool ReliableWriter::has_room(Time now) {
  forget_expired(now);
  if (!settings_.keep_all || !is_full()) return true;
  if (first() <= all_acknowledged_) remove_first();
  return !is_full();
}

void ReliableWriter::write(std::shared_ptr<const void> content, std::size_t bytes, Time now) {
  forget_expired(now);
  if (is_full()) remove_first();
  assert(!is_full());
  auto sample = std::make_shared<Sample>();
  sample->sequence = ++last_;
  sample->written = now;
  sample->bytes = bytes;
  sample->fragment_bytes = bytes > settings_.fragment_bytes ? settings_.fragment_bytes : 0;
  sample->content = std::move(content);
  history_.push_back(std::move(sample));
  if (readers_.empty()) return check_acknowledged();
  for (Reader& one : readers_) one.proxy.add(history_.back(), Status::unsent);
  send(last_, false);
  deliver_due(now);
}

// Sending.

void ReliableWriter::send(Sequence sequence, bool resent) {
  if (queue_ != nullptr) {
    queue_->add(sequence, resent);
  } else if (std::find(due_.begin(), due_.end(), sequence) == due_.end()) {
    due_.push_back(sequence);
  }
}

void ReliableWriter::deliver_due(Time now) {
  if (due_.empty()) return;
  MessageGroup group(sender_);
  for (const Sequence sequence : std::exchange(due_, {})) (void)deliver(sequence, group, now);
}

ReliableWriter::Turn ReliableWriter::next_turn(Sequence sequence) {
  Turn turn;
  for (Reader& one : readers_) {
    const auto next = one.proxy.next_unsent(sequence);
    if (!next || (!turn.readers.empty() && *next > turn.fragment)) continue;
    if (turn.readers.empty() || *next < turn.fragment) {
      turn.readers.clear();
      turn.fragment = *next;
    }
    turn.readers.push_back(&one);
  }
  return turn;
}

bool ReliableWriter::deliver(Sequence sequence, MessageGroup& group, Time now) {
  forget_expired(now);
  const SamplePtr sample = find(sequence);
  if (!sample) return true;
  for (Turn turn = next_turn(sequence); !turn.readers.empty(); turn = next_turn(sequence)) {
    fill_holes(turn, sequence, group, now);
    std::vector<EndId> receivers;
    for (const Reader* one : turn.readers) receivers.push_back(one->proxy.reader());
    group.address(receivers);
    if (!group.add_data(sample, turn.fragment)) return false;
    mark_sent(turn, sequence, now);
    piggyback(group);
  }
  return true;
}

void ReliableWriter::fill_holes(const Turn& turn, Sequence sequence, MessageGroup& group,
                                Time now) {
  for (const Reader* one : turn.readers) {
    if (!one->proxy.is_new(sequence)) continue;
    ask_for_heartbeat(now);
    const auto hole = one->proxy.hole_before(sequence, first());
    if (!hole) continue;
    group.address({one->proxy.reader()});
    group.add(Gap{*hole, sequence, {}});
    add_heartbeat(group);
  }
}

void ReliableWriter::mark_sent(const Turn& turn, Sequence sequence, Time now) {
  for (Reader* one : turn.readers) {
    if (!one->proxy.on_sent(sequence, turn.fragment)) continue;
    if (settings_.nack_suppression > Duration{0}) {
      // The timer runs on when it runs already, as Fast DDS's does.
      one->suppressed_until = std::min(one->suppressed_until, now + settings_.nack_suppression);
    } else {
      one->proxy.end_suppression();
      ask_for_heartbeat(now);
    }
  }
}

void ReliableWriter::piggyback(MessageGroup& group) {
  if (!settings_.heartbeat_piggyback) return;
  if (!is_full() && all_acknowledged_ + 1 >= first()) return;
  group.address(all_readers());
  add_heartbeat(group);
}

void ReliableWriter::add_heartbeat(MessageGroup& group) {
  group.add(Heartbeat{first(), last_, ++heartbeats_});
}

// Heartbeats.

void ReliableWriter::ask_for_heartbeat(Time now) {
  if (heartbeat_at_ == never) heartbeat_at_ = now + settings_.heartbeat_period;
}

void ReliableWriter::beat(Time now) {
  heartbeat_at_ = never;
  const Sequence since = history_.empty() ? last_ : first();
  const bool wanted = std::any_of(readers_.begin(), readers_.end(), [since](const Reader& one) {
    return one.proxy.needs_heartbeat(since);
  });
  if (!wanted) return;
  // With an empty history Fast DDS tells a single reader only.
  if (!history_.empty() || readers_.size() == 1) {
    MessageGroup group(sender_);
    group.address(all_readers());
    add_heartbeat(group);
  }
  ask_for_heartbeat(now);
}

// Time.

Time ReliableWriter::next_event() const {
  Time next = std::min(heartbeat_at_, answer_at_);
  for (const Reader& one : readers_) next = std::min(next, one.suppressed_until);
  return next;
}

void ReliableWriter::on_time(Time now) {
  forget_expired(now);
  end_suppression(now);
  if (answer_at_ <= now) answer(now);
  if (heartbeat_at_ <= now) beat(now);
}

}  // namespace tocsin::rtps
