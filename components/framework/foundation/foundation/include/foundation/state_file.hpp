// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "foundation/file_descriptor.hpp"

namespace tocsin {

/// A short text that a process keeps for its successor: a file with two slots, written in turn.
///
/// A process that is killed in the middle of a write leaves the other slot whole. The file takes
/// its room with the first write; later ones need none, so that a full disk does not stop them.
class StateFile {
 public:
  static constexpr std::size_t longest = 448;  ///< [byte]

  /// An empty path keeps nothing. Opens nothing yet.
  explicit StateFile(std::string path) : path_(std::move(path)) {}

  /// False: it keeps nothing, so that a text need not be made.
  [[nodiscard]] bool keeps() const { return !path_.empty(); }
  /// The newest whole text, also of an earlier process. Empty when there is none.
  [[nodiscard]] std::optional<std::string> load() const;
  /// False when it could not be written, and for a text that is too long; the one before is kept.
  [[nodiscard]] bool save(const std::string& text);

 private:
  [[nodiscard]] bool open();

  std::string path_;
  FileDescriptor file_;
  std::uint64_t sequence_ = 0;  ///< of the last write
};

}  // namespace tocsin
