// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "coverage/coverage_plan.hpp"

namespace tocsin::coverage {

/// Which stop of a plan is next when some are blocked: those are passed over, tried once more
/// after all others, in their order, and then given up. Pure.
class CoverageProgress {
 public:
  explicit CoverageProgress(std::vector<Stop> stops) : stops_(std::move(stops)) {}

  /// Where to drive, valid as long as this is; null when it is over.
  [[nodiscard]] const Stop* next() const;
  /// The next stop was reached, or something stands there. Asserts that there is one.
  void on_reached();
  void on_blocked();

  [[nodiscard]] std::size_t reached() const { return reached_; }
  /// Indices of the stops that were blocked twice.
  [[nodiscard]] const std::vector<std::size_t>& given_up() const { return given_up_; }

 private:
  [[nodiscard]] std::optional<std::size_t> index() const;
  std::vector<Stop> stops_;
  std::size_t first_round_ = 0;   ///< of the stops
  std::size_t second_round_ = 0;  ///< of the blocked ones
  std::vector<std::size_t> blocked_;
  std::vector<std::size_t> given_up_;
  std::size_t reached_ = 0;
};

}  // namespace tocsin::coverage
