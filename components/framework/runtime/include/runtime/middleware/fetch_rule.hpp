// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tocsin {

/// When which part of a host's log crosses without anybody asking. One of the list `fetch` of a
/// role in a traffic file.
struct FetchRule {
  /// What is asked of the field.
  enum class Is : std::uint8_t { any, above, below, equal };
  std::string when;   ///< topic whose samples are looked at
  std::string field;  ///< of its type, with dots: `twist.twist.linear.x`; empty with Is::any
  Is is = Is::any;
  double limit = 0;                 ///< of above and below
  std::string value;                ///< of equal: a number, true or false, or a text
  std::vector<std::string> topics;  ///< what crosses: logged topics, or patterns
  double before_s = 10;             ///< [s] [0, 600] of the log before that sample
  double after_s = 10;              ///< [s] [0, 600] and after it
  /// [s] [0, 86400] Samples that fulfil it and come within this time of the last that did belong
  /// to the same event: for an event once.
  double min_interval_s = 5;
  std::string name;  ///< for error texts: `uxv.fetch[0]`
};

}  // namespace tocsin
