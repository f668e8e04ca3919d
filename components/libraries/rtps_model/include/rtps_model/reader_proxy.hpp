// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "rtps_model/message.hpp"

namespace tocsin::rtps {

/// What a reliable writer knows of one reader (Fast DDS: ReaderProxy, ChangeForReader).
class ReaderProxy {
 public:
  /// Of a sample that the reader has not acknowledged.
  enum class Status : std::uint8_t {
    unsent,          ///< it, or a piece of it, is to be sent
    requested,       ///< the reader lacks it; sent when the delay of the answer is over
    unacknowledged,  ///< sent, or known from the history; may be requested
    underway,        ///< just sent: requests of the whole are ignored
  };

  /// The reader needs nothing up to `low_mark`.
  ReaderProxy(EndId reader, Sequence low_mark) : reader_(reader), low_mark_(low_mark) {}

  [[nodiscard]] EndId reader() const { return reader_; }
  /// This sample and all before it are acknowledged, or gone.
  [[nodiscard]] Sequence low_mark() const { return low_mark_; }
  [[nodiscard]] bool waits() const { return !changes_.empty(); }
  /// Whether a heartbeat is due to this reader. `first` is the first sample of the history, or the
  /// last one written when it is empty.
  [[nodiscard]] bool needs_heartbeat(Sequence first) const;

  /// A sample after all others.
  void add(const SamplePtr& sample, Status status);
  /// The history no longer has it.
  void remove(Sequence sequence);
  void acknowledge_before(Sequence base);
  /// The reader has nothing: all that the history has may be requested again.
  void start_over(const std::deque<SamplePtr>& history);

  /// What was asked for by ACKNACK. True when something is to be sent; `absent` gets those that no
  /// history has.
  [[nodiscard]] bool request(const std::vector<Sequence>& wanted, Sequence first_in_history,
                             std::vector<Sequence>& absent);
  /// What was asked for by NACK_FRAG. False when the sample is not there. Before the whole sample
  /// was sent once, nothing of it is sent twice.
  [[nodiscard]] bool request(Sequence sequence, const std::vector<Fragment>& wanted);
  /// What was requested is unsent from now on; its numbers are appended to `to_send`.
  void answer(std::vector<Sequence>& to_send);
  /// The time in which requests are ignored is over.
  void end_suppression();

  /// The next piece of a sample to send, 0 for a whole one; empty when the reader gets nothing.
  [[nodiscard]] std::optional<Fragment> next_unsent(Sequence sequence) const;
  /// Whether it was never sent whole to this reader.
  [[nodiscard]] bool is_new(Sequence sequence) const;
  /// The first of the samples just before a new one that the reader was never promised, though the
  /// history has them; empty when there are none.
  [[nodiscard]] std::optional<Sequence> hole_before(Sequence sequence,
                                                    Sequence first_in_history) const;
  /// True when that was the last piece that was unsent: the sample is underway.
  bool on_sent(Sequence sequence, Fragment fragment);

 private:
  struct Change {
    SamplePtr sample;
    Status status;
    std::vector<bool> unsent;  ///< of each fragment; empty for a whole sample
    bool delivered = false;    ///< once, whole
    void mark_all_unsent() { unsent.assign(sample->fragments(), true); }
  };
  [[nodiscard]] std::deque<Change>::iterator find(Sequence sequence);
  [[nodiscard]] std::deque<Change>::const_iterator find(Sequence sequence) const;
  EndId reader_;
  Sequence low_mark_;
  std::deque<Change> changes_;  ///< by sequence
};

}  // namespace tocsin::rtps
