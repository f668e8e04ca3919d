// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "foundation/time.hpp"

namespace tocsin::router {

/// How long a writer that is new on the host delivers nothing, since what it writes before readers
/// have found it is lost to them: until readers are there and no other follows, or for a while when
/// there are none. Pure; `now` never decreases.
class ReaderWait {
 public:
  /// Readers of one host find a new writer within milliseconds of each other; a busy computer takes
  /// longer.
  static constexpr Duration others_follow = std::chrono::milliseconds(200);

  /// The writer is made at `now`; for `patience` it waits at most.
  ReaderWait(Duration patience, Time now) : latest_(now + patience), end_(latest_) {}
  /// A reader has found it.
  void on_reader(Time now) {
    if (now < end_) end_ = std::min(now + others_follow, latest_);
  }
  [[nodiscard]] bool is_over(Time now) const { return now >= end_; }
  /// When it is over without a reader.
  [[nodiscard]] Time end() const { return end_; }

 private:
  Time latest_;
  Time end_;
};

}  // namespace tocsin::router
