// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <memory>
#include <vector>

#include "rtps_model/message.hpp"
#include "rtps_model/message_group.hpp"
#include "rtps_model/reader_proxy.hpp"

namespace tocsin::rtps {

/// QoS of a reliable writer.
struct WriterSettings {
  bool keep_all = false;  ///< else the oldest sample makes room for a new one
  std::size_t room = 1;   ///< samples in the history: the depth, or max_samples with keep_all
  bool transient_local = false;  ///< samples that all have acknowledged are kept for late readers
  std::size_t fragment_bytes = wire::largest_payload;  ///< longer samples are cut
  Duration lifespan = Duration::max();
  Duration heartbeat_period = std::chrono::milliseconds(200);
  Duration nack_response_delay{0};
  Duration nack_suppression{0};
  bool heartbeat_piggyback = true;
};

/// Who decides when a writer's samples leave: a flow controller.
class SampleQueue {
 public:
  virtual ~SampleQueue() = default;
  /// ReliableWriter::deliver is wanted for it; not again when it is there already.
  virtual void add(Sequence sequence, bool resent) = 0;
  /// It will not be delivered any more.
  virtual void remove(Sequence sequence) = 0;
};

/// A reliable writer (Fast DDS 2.9.1: StatefulWriter with DataWriterHistory, topic without key,
/// asynchronous, push mode).
///
/// A sample goes once to every reader. A heartbeat tells what the history holds: with each message
/// of samples while the history is full or a reader lacks what it has lost (with KEEP_LAST 1 that
/// is always), and every `heartbeat_period` while a reader has not acknowledged everything. What a
/// reader asks for then is sent to it again, whole or in fragments, `nack_response_delay` later; it
/// is told by GAP what no longer exists. Pure; one thread; `now` never decreases.
class ReliableWriter {
 public:
  /// `sender` and `queue` outlive the writer; without a queue samples are delivered at once.
  ReliableWriter(const WriterSettings& settings, Sender& sender, SampleQueue* queue = nullptr);
  ReliableWriter(const ReliableWriter&) = delete;
  ReliableWriter& operator=(const ReliableWriter&) = delete;

  [[nodiscard]] Sequence next_sequence() const { return last_ + 1; }
  /// False for a full history of keep_all in which no sample may go.
  [[nodiscard]] bool has_room(Time now);
  /// There must be room.
  void write(std::shared_ptr<const void> content, std::size_t bytes, Time now);
  void match(EndId reader, Time now);
  void unmatch(EndId reader, Time now);
  /// Forgets all samples: neither data nor heartbeat is sent for them any more.
  void clear();
  void on_message(EndId reader, const Message& message, Time now);

  /// When on_time() has work; `never` when all is at rest.
  [[nodiscard]] Time next_event() const;
  void on_time(Time now);

  /// Sends what readers are to get of a sample; for the queue. False when the budget of the group
  /// was over before all was sent.
  [[nodiscard]] bool deliver(Sequence sequence, MessageGroup& group, Time now);
  /// Null when the history does not have it.
  [[nodiscard]] SamplePtr find(Sequence sequence) const;

 private:
  struct Reader {
    ReaderProxy proxy;
    std::uint32_t acknack_count = 0;
    std::uint32_t nack_frag_count = 0;
    Time suppressed_until = never;
  };
  /// Readers that lack the same piece of a sample.
  struct Turn {
    Fragment fragment = 0;
    std::vector<Reader*> readers;
  };
  [[nodiscard]] bool is_full() const { return history_.size() >= settings_.room; }
  [[nodiscard]] Sequence first() const;
  [[nodiscard]] std::vector<EndId> all_readers() const;
  [[nodiscard]] Reader* reader_of(EndId reader);
  void forget_expired(Time now);
  void remove_first();
  void check_acknowledged();
  void send(Sequence sequence, bool resent);
  void deliver_due(Time now);
  [[nodiscard]] Turn next_turn(Sequence sequence);
  void fill_holes(const Turn& turn, Sequence sequence, MessageGroup& group, Time now);
  void mark_sent(const Turn& turn, Sequence sequence, Time now);
  void piggyback(MessageGroup& group);
  void add_heartbeat(MessageGroup& group);
  void ask_for_heartbeat(Time now);
  void beat(Time now);
  void on_acknack(Reader& reader, const AckNack& acknack, Time now);
  void on_first_acknack(Reader& reader, Time now);
  void on_nack_frag(Reader& reader, const NackFrag& nack, Time now);
  void ask_for_answer(Time now);
  void answer(Time now);
  void end_suppression(Time now);

  WriterSettings settings_;
  Sender& sender_;
  SampleQueue* queue_;
  std::deque<SamplePtr> history_;
  std::deque<Reader> readers_;
  Sequence last_ = 0;
  Sequence all_acknowledged_ = 0;  ///< by every reader, up to this one
  std::uint32_t heartbeats_ = 0;
  Time heartbeat_at_ = never;
  Time answer_at_ = never;
  std::vector<Sequence> due_;  ///< to be delivered before the call returns
};

}  // namespace tocsin::rtps
