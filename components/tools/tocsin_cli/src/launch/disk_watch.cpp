// SPDX-License-Identifier: Apache-2.0
#include "disk_watch.hpp"

#include <utility>

#include "foundation/free_space.hpp"

namespace tocsin::cli {

DiskWatch::State DiskWatch::judge(std::optional<std::uint64_t> free_bytes) const {
  if (!free_bytes) return State::gone;
  // Twice the room ends it, so that a disk at the limit is not told again and again.
  const std::uint64_t limit = state_ == State::full ? 2 * full_below_bytes : full_below_bytes;
  return *free_bytes < limit ? State::full : State::fine;
}

std::optional<std::string> DiskWatch::on_look(std::optional<std::uint64_t> free_bytes) {
  const State before = std::exchange(state_, judge(free_bytes));
  if (state_ == before) return std::nullopt;
  const std::string goes_on = "; the vehicle and the emergency stop do not need it";
  switch (state_) {
    case State::full:
      return "DISK FULL: recordings and logs in " + folder_ + " are lost" + goes_on;
    case State::gone:
      return "RUN FOLDER GONE: " + folder_ + " was removed; what is recorded is lost" + goes_on;
    case State::fine:
      break;
  }
  return before == State::full ? "the disk of " + folder_ + " has room again"
                               : folder_ + " is there again";
}

}  // namespace tocsin::cli
