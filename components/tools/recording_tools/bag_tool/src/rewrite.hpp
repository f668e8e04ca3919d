// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "bag/bag_writer.hpp"
#include "topic_choice.hpp"

namespace tocsin::bag_tool {

/// What goes from old bags into a new one.
struct RewriteOrder {
  std::vector<std::string> inputs;
  std::string output;
  TopicWishes topics;
  double start_offset_s = 0;  ///< [s] after the earliest message of all inputs
  double duration_s = std::numeric_limits<double>::infinity();  ///< [s] from there
  bag::BagOptions options;
};

struct Rewritten {
  std::uint64_t messages = 0;
  std::uint64_t lost = 0;           ///< for which the new bag had no room
  std::vector<std::string> damage;  ///< what the inputs lack, a line each
};

/// Copies messages of all inputs, in order of log time, with topics, attachments and metadata into
/// a new bag. Topics of one name and type become one. Throws ConfigError for what is no bag, and
/// when the output is there already.
[[nodiscard]] Rewritten rewrite(const RewriteOrder& order);

}  // namespace tocsin::bag_tool
