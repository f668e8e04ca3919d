// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "rtps_model/reliable_writer.hpp"
#include "sent_messages.hpp"

namespace tocsin::rtps {

using Sequences = std::vector<Sequence>;
using Fragments = std::vector<Fragment>;

constexpr EndId reader = 7;
constexpr EndId other = 8;

inline WriterSettings keep_last(std::size_t depth, bool transient_local = false) {
  WriterSettings settings;
  settings.room = depth;
  settings.transient_local = transient_local;
  return settings;
}

class ReliableWriterTest : public ::testing::Test {
 protected:
  /// A writer whose readers have answered the heartbeat of the match.
  ReliableWriter& make(const WriterSettings& settings,
                       const std::vector<EndId>& readers = {reader}) {
    sut_.emplace(settings, sent_);
    for (const EndId one : readers) sut_->match(one, t0);
    for (const EndId one : readers) acknowledge(one, 1, {}, 0);
    sent_.clear();
    return *sut_;
  }
  void write(std::size_t bytes = 100, double s = 0) { sut_->write(nullptr, bytes, at(s)); }
  /// `reader` has all before `base`, wants `missing`.
  void acknowledge(EndId from, Sequence base, const Sequences& missing, double s) {
    sut_->on_message(from, message_of({AckNack{base, missing, ++acknacks_}}), at(s));
  }
  void want_pieces(EndId from, Sequence sequence, const Fragments& missing, double s) {
    sut_->on_message(from, message_of({NackFrag{sequence, missing, ++acknacks_}}), at(s));
  }
  /// Does what is due up to `s`.
  void run_until(double s) {
    while (sut_->next_event() <= at(s)) sut_->on_time(sut_->next_event());
  }
  [[nodiscard]] Heartbeat last_heartbeat(EndId to) const {
    return sent_.parts<Heartbeat>(to).back();
  }
  SentMessages sent_;
  std::optional<ReliableWriter> sut_;
  std::uint32_t acknacks_ = 0;
};

}  // namespace tocsin::rtps
