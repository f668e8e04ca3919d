// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>

#include "rtps_model/message.hpp"
#include "rtps_model/message_group.hpp"
#include "rtps_model/reader_history.hpp"
#include "rtps_model/writer_proxy.hpp"

namespace tocsin::rtps {

/// A reliable reader (Fast DDS 2.9.1: StatefulReader with DataReaderHistory, topic without key).
///
/// Gives the samples of each writer in order and each once, and waits for those that can still
/// come. Every heartbeat is answered, `heartbeat_response_delay` after the message that brought it:
/// an ACKNACK names samples of which nothing has come, a NACK_FRAG the missing pieces of another.
/// Until the first heartbeat it calls the writer every `initial_acknack_delay`. Pure; one thread;
/// `now` never decreases.
class ReliableReader {
 public:
  using Deliver = std::function<void(EndId writer, const SamplePtr& sample)>;
  /// `sender` outlives the reader; its messages go to writers.
  ReliableReader(const ReaderSettings& settings, Sender& sender, Deliver deliver);
  ReliableReader(const ReliableReader&) = delete;
  ReliableReader& operator=(const ReliableReader&) = delete;

  void match(EndId writer, Time now);
  void unmatch(EndId writer);
  /// Messages of a writer that is not matched are ignored.
  void on_message(EndId writer, const Message& message, Time now);

  /// When on_time() has work; `never` when all is at rest.
  [[nodiscard]] Time next_event() const;
  void on_time(Time now);

 private:
  struct Writer {
    WriterProxy proxy;
    std::uint32_t heartbeats = 0;  ///< count of the last one; 0: none came
    std::uint32_t acknacks = 0;
    std::uint32_t nack_frags = 0;
    Time answer_at = never;
    Time call_at = never;
  };
  void on_data(EndId id, Writer& writer, const Data& data);
  void on_piece(EndId id, Writer& writer, const Data& data);
  void on_heartbeat(EndId id, Writer& writer, const Heartbeat& heartbeat, Time now);
  void on_gap(EndId id, Writer& writer, const Gap& gap);
  void settle_gone(EndId id, Writer& writer, Sequence sequence);
  void settle_dropped(const std::vector<ReaderHistory::Key>& dropped);
  void give(EndId id, const Writer& writer);
  void answer(EndId id, Writer& writer);
  void call(EndId id, Writer& writer, Time now);

  ReaderSettings settings_;
  Sender& sender_;
  Deliver deliver_;
  ReaderHistory history_;
  std::map<EndId, Writer> writers_;
};

}  // namespace tocsin::rtps
