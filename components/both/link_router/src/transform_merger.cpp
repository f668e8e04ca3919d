// SPDX-License-Identifier: Apache-2.0
#include "transform_merger.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

namespace tocsin {
namespace {

bool is_older(const geometry_msgs::msg::TransformStamped& one,
              const geometry_msgs::msg::TransformStamped& other) {
  const auto& a = one.header().stamp();
  const auto& b = other.header().stamp();
  return std::make_tuple(a.sec(), a.nanosec()) < std::make_tuple(b.sec(), b.nanosec());
}

}  // namespace

void TransformMerger::add(const Message& message, std::int64_t sent_wall_ns) {
  sent_wall_ns_ = std::max(sent_wall_ns_, sent_wall_ns);
  for (const auto& transform : message.transforms()) {
    const auto found = waiting_.find(transform.child_frame_id());
    if (found == waiting_.end()) {
      if (waiting_.size() < most_frames) waiting_.emplace(transform.child_frame_id(), transform);
    } else if (!is_older(transform, found->second)) {
      found->second = transform;
    }
  }
}

std::optional<TransformMerger::Merged> TransformMerger::take(Time now) {
  if (waiting_.empty() || now < next_) return std::nullopt;
  Merged merged;
  merged.sent_wall_ns = std::exchange(sent_wall_ns_, 0);
  for (auto& entry : waiting_) merged.message.transforms().push_back(std::move(entry.second));
  waiting_.clear();
  next_ = now + interval_;
  return merged;
}

}  // namespace tocsin
