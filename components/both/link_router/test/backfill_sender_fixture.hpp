// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <optional>
#include <vector>

#include "link_router/backfill_sender.hpp"

namespace tocsin::router {

using sample_log::LogEntry;
using sample_log::Logged;
using sample_log::SampleId;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

inline constexpr Time t0{std::chrono::hours(1)};
inline constexpr Duration ms = std::chrono::milliseconds(1);
inline constexpr double capacity_bytes_per_s = 1e6;

class BackfillSenderTest : public ::testing::Test {
 protected:
  [[nodiscard]] static SampleId id(std::uint64_t sequence, std::uint64_t source = 2,
                                   std::uint64_t stream = 1) {
    return {stream, source, sequence};
  }
  /// Goes to the log and does not cross.
  void miss(const SampleId& which) {
    sut_.offer(which);
    sut_.on_logged(which, Logged::kept);
    EXPECT_FALSE(sut_.on_fate(which, LiveFate::did_not_cross));
  }
  void read_all(std::size_t bytes = 100) {
    for (auto wanted = sut_.take_wanted(); !wanted.empty(); wanted = sut_.take_wanted()) {
      std::vector<LogEntry> read;
      for (const SampleId& one : wanted) {
        read.push_back({one, 0, std::vector<std::uint8_t>(bytes)});
      }
      sut_.on_read(wanted, read);
    }
  }
  std::optional<BackfillBatch> next() { return sut_.next(now_, capacity_bytes_per_s); }
  [[nodiscard]] static std::vector<std::uint64_t> sequences(const BackfillBatch& batch) {
    std::vector<std::uint64_t> all;
    for (const LogEntry& entry : batch.samples) all.push_back(entry.id.sequence);
    return all;
  }
  [[nodiscard]] const StoredCounts& counts() const { return sut_.counts().at(1); }

  LinkRouterParams params_;
  BackfillSender sut_{params_};
  Time now_ = t0;
};

}  // namespace tocsin::router
