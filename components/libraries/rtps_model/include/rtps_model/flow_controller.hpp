// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "rtps_model/message.hpp"
#include "rtps_model/message_group.hpp"

namespace tocsin::rtps {

/// Whose sample goes next.
enum class Schedule : std::uint8_t { fifo, round_robin, high_priority, priority_with_reservation };

/// Sends the samples of a participant's asynchronous writers, so many bytes in each period (Fast
/// DDS 2.9.1: FlowControllerImpl).
///
/// Within a queue new samples go before those that are sent again. A sample that does not fit what
/// is left of the period goes on, with the fragments that are left, when the next one begins; until
/// then nothing goes. Periods follow each other from the start. Bytes are those of the messages,
/// without IP and UDP; a message for several readers counts once. Pure; one thread.
class FlowController {
 public:
  struct Settings {
    Schedule schedule = Schedule::high_priority;
    std::size_t max_bytes_per_period = 0;  ///< at least 1
    Duration period = std::chrono::milliseconds(10);
  };
  /// What a writer is entitled to.
  struct Share {
    int priority = 10;            ///< -10 goes first
    int reservation_percent = 0;  ///< of each period, before others; for the last schedule
  };
  /// A sample that waits.
  struct Entry {
    std::size_t writer;  ///< as add_writer() has numbered it
    Sequence sequence;
    std::size_t bytes;
    std::size_t fragment_bytes;  ///< 0: whole
  };
  /// Sends what is to be sent of a sample; false when the budget was over before.
  using Deliver = std::function<bool(const Entry& entry, ByteBudget& budget)>;

  FlowController(const Settings& settings, Time start);

  std::size_t add_writer(const Share& share);
  /// Nothing happens when the sample waits already.
  void add(const Entry& entry, bool resent);
  void remove(std::size_t writer, Sequence sequence);
  /// Delivers what may go at `now`.
  void run(Time now, const Deliver& deliver);
  /// When run() has work next, after it ran: the next period, or `never` when nothing waits.
  [[nodiscard]] Time next_event() const;

 private:
  struct Queue {
    std::deque<Entry> fresh;
    std::deque<Entry> resent;
    [[nodiscard]] bool empty() const { return fresh.empty() && resent.empty(); }
    [[nodiscard]] std::deque<Entry>& first() { return fresh.empty() ? resent : fresh; }
  };
  struct Writer {
    Share share;
    std::size_t queue;
    std::size_t reserved;  ///< [byte] of each period
    std::size_t used = 0;  ///< [byte] of these
  };
  /// The queue whose first sample goes next.
  struct Choice {
    std::size_t queue;
    bool by_reservation;
  };
  [[nodiscard]] std::size_t new_queue();
  void begin_period(Time now);
  [[nodiscard]] bool fits(const Entry& entry) const;
  [[nodiscard]] std::optional<Choice> choose();
  [[nodiscard]] std::optional<Choice> choose_in_turn();
  [[nodiscard]] std::optional<Choice> choose_reserved();
  [[nodiscard]] bool deliver_next(const Choice& choice, const Deliver& deliver);
  Settings settings_;
  Time period_begin_;
  ByteBudget budget_;
  bool waits_for_period_ = false;
  std::vector<Queue> queues_;
  std::vector<Writer> writers_;
  std::vector<std::size_t> by_priority_;  ///< writers, those of equal priority as they were added
  std::size_t turn_ = 0;                  ///< of round_robin: the queue
};

}  // namespace tocsin::rtps
