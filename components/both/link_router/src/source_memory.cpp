// SPDX-License-Identifier: Apache-2.0
#include "link_router/source_memory.hpp"

#include <algorithm>

namespace tocsin::router {
namespace {

/// A row whose numbers do not rise for so long is over: its highest number was another hint.
constexpr Duration row_for = std::chrono::milliseconds(500);

}  // namespace

SourceMemory::Verdict SourceMemory::judge(std::uint64_t sequence, std::size_t depth, bool fresh,
                                          Time now) {
  received_ = now;
  const auto place = std::lower_bound(newest_.begin(), newest_.end(), sequence);
  if (place != newest_.end() && *place == sequence) return Verdict::duplicate;
  const bool behind = newest_.size() >= depth && place == newest_.begin();
  if (!behind && sequence >= floor_) return Verdict::newer;
  if (!is_confirmed(sequence, now) || !fresh) return Verdict::superseded;
  newest_.clear();
  floor_ = sequence;
  contrary_.reset();
  return Verdict::newer;
}

bool SourceMemory::is_confirmed(std::uint64_t sequence, Time now) {
  const bool begins =
      !contrary_ || (sequence < contrary_->highest && now - contrary_->rose >= row_for);
  if (begins) contrary_ = {sequence, now, now};
  if (sequence <= contrary_->highest) return false;
  contrary_->highest = sequence;
  contrary_->rose = now;
  return now - contrary_->since >= contrary_for && now - added_ >= contrary_for;
}

void SourceMemory::add(std::uint64_t sequence, std::size_t depth, Time now) {
  newest_.insert(std::lower_bound(newest_.begin(), newest_.end(), sequence), sequence);
  if (newest_.size() > depth) newest_.erase(newest_.begin());
  contrary_.reset();
  added_ = now;
}

}  // namespace tocsin::router
