// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace tocsin::cli {

/// Says when the disk of the run folder becomes full, when the folder goes away, and when either is
/// over; each of them once. Pure.
class DiskWatch {
 public:
  explicit DiskWatch(std::string folder) : folder_(std::move(folder)) {}
  /// What to say, if anything, now that there is room for so many bytes; empty: the folder is gone.
  [[nodiscard]] std::optional<std::string> on_look(std::optional<std::uint64_t> free_bytes);

 private:
  enum class State { fine, full, gone };
  [[nodiscard]] State judge(std::optional<std::uint64_t> free_bytes) const;
  std::string folder_;
  State state_ = State::fine;
};

}  // namespace tocsin::cli
