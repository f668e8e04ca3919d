// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "runtime/logger.hpp"

namespace tocsin {

/// What a router did not take, by name and peer. Sums since the start; bounded, since a stranger
/// chooses the names. All texts are printable.
class RefusedNames {
 public:
  /// Names of peers that have a line of their own; all others are counted together.
  static constexpr std::size_t most_lines = 64;
  static constexpr const char* others = "others";

  enum class News {
    none,
    first,  ///< of this name
    full,   ///< this and later names have no line of their own
  };
  News add(const std::string& name, const std::string& peer);
  [[nodiscard]] std::uint64_t total() const { return total_; }
  /// "cmd_vel from gcs" with its count.
  [[nodiscard]] const std::map<std::string, std::uint64_t>& lines() const { return lines_; }

 private:
  std::uint64_t total_ = 0;
  std::map<std::string, std::uint64_t> lines_;
  std::set<std::string> names_;
};

/// Counts what this process's router was offered and did not take: `name` as it is on the wire,
/// `what` of it ("topic", "service"). Logs one warning for each name, and one when there are too
/// many of them. Any thread.
void refuse(const std::string& what, const std::string& name, const std::string& peer, Logger& log);
/// All of them since the process began. Any thread.
[[nodiscard]] RefusedNames refused_names();

}  // namespace tocsin
