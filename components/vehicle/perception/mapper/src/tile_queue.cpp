// SPDX-License-Identifier: Apache-2.0
#include "mapper/tile_queue.hpp"

#include <algorithm>

namespace tocsin {
namespace {

template <class Turns>
auto earliest(const Turns& turns) {
  return std::min_element(turns.begin(), turns.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; });
}

}  // namespace

void TileQueue::on_change(Index index) { changed_.emplace(index, ++turn_); }

std::optional<TileQueue::Index> TileQueue::next_changed() {
  if (changed_.empty()) return std::nullopt;
  const auto found = earliest(changed_);
  const Index index = found->first;
  changed_.erase(found);
  sent_[index] = ++turn_;
  return index;
}

std::optional<TileQueue::Index> TileQueue::next_repeat() {
  if (!changed_.empty() || sent_.empty()) return std::nullopt;
  const Index index = earliest(sent_)->first;
  sent_[index] = ++turn_;
  return index;
}

}  // namespace tocsin
