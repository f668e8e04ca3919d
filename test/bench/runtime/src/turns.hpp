// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "measure.hpp"

namespace tocsin::bench {

/// A way of doing round trips, set up for one size of message.
class Way {
 public:
  virtual ~Way() = default;
  /// False when an answer did not come.
  virtual bool run(int trips, Series& series) = 0;
};

/// What is printed of a way, and the numbers of the ways that its shares are of.
struct Title {
  const char* name;
  std::vector<std::size_t> rivals;
};

/// The ways of a comparison from their set-up to their end.
struct Generation {
  std::shared_ptr<void> others;  ///< whoever answers, destroyed last
  std::vector<std::unique_ptr<Way>> ways;
};

struct Plan {
  int generations;     ///< where the scheduler puts a process, and the allocator an object, stays
  std::size_t rounds;  ///< of a generation; in each, every way has as many turns as there are ways
  int trips;           ///< in a turn that count; a tenth as many go before
};

/// The ways take turns, a few round trips each, each way in every place, so that a machine whose
/// speed changes changes it for all. Prints median and 99th percentile in microseconds, and their
/// shares of the rival's: the median over the generations, which alone are independent, with its
/// 95 % confidence interval.
void compare(const std::string& load, const std::vector<Title>& titles, const Plan& plan,
             const std::function<Generation()>& set_up);

}  // namespace tocsin::bench
