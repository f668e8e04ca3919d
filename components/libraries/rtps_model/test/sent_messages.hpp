// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "rtps_model/message.hpp"

namespace tocsin::rtps {

inline const Time t0{std::chrono::hours(1)};

inline Time at(double s) { return t0 + seconds(s); }

/// Keeps what is sent.
class SentMessages final : public Sender {
 public:
  struct Sent {
    EndId to;
    MessagePtr message;
  };
  void send(EndId to, const MessagePtr& message) override { all.push_back({to, message}); }

  /// The submessages of a kind in all messages to a receiver, in order.
  template <class Part>
  [[nodiscard]] std::vector<Part> parts(EndId to) const {
    std::vector<Part> found;
    for (const Sent& one : all) {
      if (one.to != to) continue;
      for (const Submessage& part : one.message->parts) {
        if (const auto* wanted = std::get_if<Part>(&part)) found.push_back(*wanted);
      }
    }
    return found;
  }
  /// Sequences of the DATA to a receiver.
  [[nodiscard]] std::vector<Sequence> data(EndId to) const {
    std::vector<Sequence> found;
    for (const Data& one : parts<Data>(to)) found.push_back(one.sample->sequence);
    return found;
  }
  /// Numbers of the fragments to a receiver.
  [[nodiscard]] std::vector<Fragment> fragments(EndId to) const {
    std::vector<Fragment> found;
    for (const Data& one : parts<Data>(to)) found.push_back(one.fragment);
    return found;
  }
  /// Forgets them.
  void clear() { all.clear(); }

  std::vector<Sent> all;
};

inline SamplePtr sample_of(Sequence sequence, std::size_t bytes = 100, Time written = t0,
                           std::size_t fragment_bytes = wire::largest_payload) {
  auto sample = std::make_shared<Sample>();
  sample->sequence = sequence;
  sample->written = written;
  sample->bytes = bytes;
  sample->fragment_bytes = bytes > fragment_bytes ? fragment_bytes : 0;
  return sample;
}

inline Message message_of(std::vector<Submessage> parts) { return {std::move(parts), 0}; }

}  // namespace tocsin::rtps
