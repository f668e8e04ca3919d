// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "foundation/time.hpp"

namespace tocsin::router {

/// Which samples of one source the host was delivered: of each number one, and none behind `depth`
/// newer ones.
///
/// A number is a hint until traffic confirms it: when for 0.8 s only lower, rising numbers are
/// received, at least two, and the last is fresh, the higher ones are forgotten. What is repaired
/// or replayed so late is not fresh. Pure; `now` never decreases.
class SourceMemory {
 public:
  enum class Verdict : std::uint8_t { newer, duplicate, superseded };
  /// How long contrary traffic lasts until it counts.
  static constexpr Duration contrary_for = std::chrono::milliseconds(800);

  /// What a received sample is. `fresh`: it was sent a moment ago by its source's clock.
  [[nodiscard]] Verdict judge(std::uint64_t sequence, std::size_t depth, bool fresh, Time now);
  /// The host was delivered a sample that was judged newer.
  void add(std::uint64_t sequence, std::size_t depth, Time now);
  /// When something of the source was received.
  [[nodiscard]] Time received() const { return received_; }

 private:
  /// Samples of lower numbers in a row.
  struct Contrary {
    std::uint64_t highest;
    Time since;
    Time rose;  ///< when the highest was received
  };
  [[nodiscard]] bool is_confirmed(std::uint64_t sequence, Time now);

  std::vector<std::uint64_t> newest_;  ///< rising, `depth` at most
  std::uint64_t floor_ = 0;            ///< what is below counts as delivered
  std::optional<Contrary> contrary_;
  Time added_{};
  Time received_{};
};

}  // namespace tocsin::router
