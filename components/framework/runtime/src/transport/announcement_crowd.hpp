// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>

#include "foundation/time.hpp"

namespace tocsin {

/// Decides how long to let announcements come before they are heard together.
///
/// A participant announces itself twice a second, so n of them wake each other 2 n^2 times a
/// second, and waking costs more than hearing. Who has few around him, or has just begun, hears
/// each at once: what a new participant says next is thrown away until it is known. Pure.
class AnnouncementCrowd {
 public:
  /// One has come. `now` must not decrease.
  [[nodiscard]] Duration on_announcement(Time now) {
    if (!since_ || now - *since_ >= window) {
      is_crowd_ = since_ && now - *since_ < 2 * window && count_ > most_heard_at_once;
      since_ = now;
      count_ = 0;
    }
    ++count_;
    return is_crowd_ ? pause : Duration::zero();
  }

  static constexpr Duration pause = std::chrono::milliseconds(50);

 private:
  static constexpr Duration window = std::chrono::seconds(5);
  static constexpr int most_heard_at_once = 200;  // in a window: of 20 participants

  std::optional<Time> since_;
  int count_ = 0;
  bool is_crowd_ = false;
};

}  // namespace tocsin
