// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace tocsin {

/// When which part of a host's log crosses without anybody asking. One of the list `fetch` of a
/// role in a traffic file.
struct FetchRule {
  std::string when;  ///< topic whose samples are looked at
  /// A number or truth (0 or 1) of its type, with dots: `twist.twist.linear.x`; a sample fulfils
  /// the rule when it is above `above` and below `below`. Empty: every sample does.
  std::string field;
  double above = 0;
  double below = std::numeric_limits<double>::infinity();
  std::vector<std::string> topics;  ///< what crosses: logged topics, or patterns
  double before_s = 10;             ///< [s] [0, 600] of the log before that sample
  double after_s = 10;              ///< [s] [0, 600] and after it
  /// [s] [0, 86400] Samples that fulfil it and come within this time of the last that did belong
  /// to the same event: for an event once.
  double min_interval_s = 5;
  std::string name;  ///< for error texts: `uxv.fetch[0]`
};

}  // namespace tocsin
