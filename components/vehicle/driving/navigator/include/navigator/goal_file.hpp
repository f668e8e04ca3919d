// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "foundation/state_file.hpp"
#include "foundation/time.hpp"
#include "navigator/goal_list.hpp"

namespace tocsin {

/// Keeps the goal that is driven to in a file, so that a navigator that died and was restarted by
/// its launcher, perhaps where nobody hears it, goes on until the goal's lease is over. A new
/// launch starts afresh: what another parent process has left is not read.
class GoalFile {
 public:
  static constexpr std::size_t most_ahead = 8;  ///< that are kept of those ahead
  /// An empty path keeps nothing.
  explicit GoalFile(std::string path) : file_(std::move(path)) {}

  /// With poses to a millimetre. Empty when there is no file, it is damaged, or it is of another
  /// launch; GoalList refuses what has expired.
  [[nodiscard]] std::optional<Goal> load() const;
  /// False when it could not be written; the one before is kept then. Writes what has changed only.
  [[nodiscard]] bool save(const Goal& goal);
  /// Nothing is gone on with.
  [[nodiscard]] bool clear() { return keep(""); }

 private:
  [[nodiscard]] bool keep(const std::string& text);
  StateFile file_;
  std::string saved_;
};

}  // namespace tocsin
