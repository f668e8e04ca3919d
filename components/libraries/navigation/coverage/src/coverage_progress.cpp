// SPDX-License-Identifier: Apache-2.0
#include "coverage/coverage_progress.hpp"

#include <cassert>

namespace tocsin::coverage {

std::optional<std::size_t> CoverageProgress::index() const {
  if (first_round_ < stops_.size()) return first_round_;
  if (second_round_ < blocked_.size()) return blocked_[second_round_];
  return std::nullopt;
}

const Stop* CoverageProgress::next() const {
  const auto at = index();
  return at ? &stops_[*at] : nullptr;
}

void CoverageProgress::on_reached() {
  assert(index());
  ++reached_;
  ++(first_round_ < stops_.size() ? first_round_ : second_round_);
}

void CoverageProgress::on_blocked() {
  assert(index());
  if (first_round_ < stops_.size()) {
    blocked_.push_back(first_round_++);
  } else {
    given_up_.push_back(blocked_[second_round_++]);
  }
}

}  // namespace tocsin::coverage
