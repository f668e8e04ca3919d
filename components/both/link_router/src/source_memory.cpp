// SPDX-License-Identifier: Apache-2.0
#include "link_router/source_memory.hpp"

#include <algorithm>

namespace tocsin::router {

SourceMemory::Verdict SourceMemory::judge(std::uint64_t sequence, std::size_t depth, bool fresh,
                                          Time now) {
  heard_ = now;
  const auto place = std::lower_bound(newest_.begin(), newest_.end(), sequence);
  if (place != newest_.end() && *place == sequence) return Verdict::duplicate;
  const bool behind = newest_.size() >= depth && place == newest_.begin();
  if (!behind && sequence >= floor_) return Verdict::newer;
  if (!fresh || !is_confirmed(sequence, now)) return Verdict::superseded;
  newest_.clear();
  floor_ = sequence;
  contrary_.reset();
  return Verdict::newer;
}

bool SourceMemory::is_confirmed(std::uint64_t sequence, Time now) {
  if (!contrary_) {
    contrary_ = {sequence, now};
    return false;
  }
  if (sequence <= contrary_->highest) return false;
  contrary_->highest = sequence;
  return now - contrary_->since >= contrary_for && now - added_ >= contrary_for;
}

void SourceMemory::add(std::uint64_t sequence, std::size_t depth, Time now) {
  newest_.insert(std::lower_bound(newest_.begin(), newest_.end(), sequence), sequence);
  if (newest_.size() > depth) newest_.erase(newest_.begin());
  contrary_.reset();
  added_ = now;
}

}  // namespace tocsin::router
