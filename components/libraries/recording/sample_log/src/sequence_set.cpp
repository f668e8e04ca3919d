// SPDX-License-Identifier: Apache-2.0
#include "sample_log/sequence_set.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <limits>

namespace tocsin::sample_log {

bool SequenceSet::contains(std::uint64_t sequence) const {
  const auto after = ranges_.upper_bound(sequence);
  return after != ranges_.begin() && std::prev(after)->second >= sequence;
}

bool SequenceSet::insert(std::uint64_t sequence) {
  if (contains(sequence)) return false;
  insert(sequence, sequence);
  return true;
}

void SequenceSet::insert(std::uint64_t first, std::uint64_t last) {
  assert(first <= last);
  auto place = ranges_.upper_bound(first);
  if (place != ranges_.begin()) {
    const auto before = std::prev(place);
    if (before->second >= first || before->second + 1 == first) {
      first = before->first;
      last = std::max(last, before->second);
      ranges_.erase(before);
    }
  }
  const std::uint64_t touches = last == std::numeric_limits<std::uint64_t>::max() ? last : last + 1;
  while (place != ranges_.end() && place->first <= touches) {
    last = std::max(last, place->second);
    place = ranges_.erase(place);
  }
  ranges_.emplace(first, last);
}

void SequenceSet::close_gaps(std::size_t most_ranges) {
  while (ranges_.size() > std::max<std::size_t>(most_ranges, 1)) {
    const auto second = std::next(ranges_.begin());
    ranges_.begin()->second = second->second;
    ranges_.erase(second);
  }
}

}  // namespace tocsin::sample_log
