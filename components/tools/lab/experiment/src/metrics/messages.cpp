// SPDX-License-Identifier: Apache-2.0
#include "metrics/messages.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace tocsin::experiment {
namespace {

using report::Arrival;

/// What arrived of one writer of one topic.
struct Writer {
  const Arrival* first;
  std::vector<const Arrival*> arrivals;
  [[nodiscard]] bool wrote(const Arrival& one) const {
    return first->writer == one.writer && first->topic == one.topic;
  }
};

/// In the order of topics and writers; of each in the order of its sequence, which is nearly that
/// of arrival. Links have few writers.
std::vector<Writer> by_writer(const std::vector<Arrival>& arrivals) {
  std::vector<Writer> writers;
  for (const Arrival& one : arrivals) {
    auto found = std::find_if(writers.begin(), writers.end(),
                              [&](const Writer& writer) { return writer.wrote(one); });
    if (found == writers.end()) found = writers.insert(found, {&one, {}});
    found->arrivals.push_back(&one);
  }
  std::sort(writers.begin(), writers.end(), [](const Writer& a, const Writer& b) {
    return std::tie(a.first->topic, a.first->writer) < std::tie(b.first->topic, b.first->writer);
  });
  const auto in_sequence = [](const Arrival* a, const Arrival* b) {
    return a->sequence < b->sequence;
  };
  for (Writer& writer : writers) {
    auto& all = writer.arrivals;
    if (!std::is_sorted(all.begin(), all.end(), in_sequence)) {
      std::sort(all.begin(), all.end(), in_sequence);
    }
  }
  return writers;
}

/// The messages of a writer, those that were sent within a time only.
class Sent {
 public:
  Sent(double begin_s, double end_s, std::vector<Message>& messages)
      : begin_s_(begin_s), end_s_(end_s), messages_(messages) {}

  void add(const Writer& writer) {
    const bool camera = writer.first->topic == camera_topic;
    const Arrival* before = nullptr;
    for (const Arrival* one : writer.arrivals) {
      if (before != nullptr) add_lost(*before, *one, camera);
      add({one->sent_s, std::max(0.0, one->received_s - one->sent_s), camera});
      before = one;
    }
  }

 private:
  /// The samples missing between two neighbours.
  void add_lost(const Arrival& before, const Arrival& after, bool camera) {
    if (after.sequence <= before.sequence + 1) return;
    const auto steps = static_cast<double>(after.sequence - before.sequence);
    const double step_s = (after.sent_s - before.sent_s) / steps;
    for (std::uint64_t i = 1; i < after.sequence - before.sequence; ++i) {
      add({before.sent_s + static_cast<double>(i) * step_s, std::nan(""), camera});
    }
  }
  void add(const Message& message) {
    if (message.sent_s >= begin_s_ && message.sent_s < end_s_) messages_.push_back(message);
  }
  double begin_s_;
  double end_s_;
  std::vector<Message>& messages_;
};

}  // namespace

std::vector<Message> messages_of(const std::vector<Arrival>& arrivals, double begin_s,
                                 double end_s) {
  std::vector<Message> messages;
  Sent sent(begin_s, end_s, messages);
  for (const Writer& writer : by_writer(arrivals)) sent.add(writer);
  return messages;
}

}  // namespace tocsin::experiment
