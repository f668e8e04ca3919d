// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "foundation/time.hpp"
#include "ros_idl/tf2_msgs.hpp"

namespace tocsin {

/// `max_rate_hz` of transforms: of all writers' messages one each interval, with the newest of
/// every transform that came since. Thinned by message, of a writer that sends its frames one by
/// one some would never cross. A frame is known by its name, since it has one parent at a time; the
/// newest by its stamp, as tf2 has it. Pure.
class TransformMerger {
 public:
  using Message = tf2_msgs::msg::TFMessage;
  /// Frames that wait at once; further ones are left out.
  static constexpr std::size_t most_frames = 1000;

  explicit TransformMerger(Duration interval) : interval_(interval) {}

  /// `sent_wall_ns` [ns since the Unix epoch] by its writer.
  void add(const Message& message, std::int64_t sent_wall_ns);
  struct Merged {
    Message message;
    std::int64_t sent_wall_ns = 0;  ///< of the newest message in it
  };
  /// What is due at `now`, if anything.
  [[nodiscard]] std::optional<Merged> take(Time now);
  /// When take() has something; `never` when nothing waits.
  [[nodiscard]] Time deadline() const { return waiting_.empty() ? never : next_; }

 private:
  const Duration interval_;
  std::map<std::string, geometry_msgs::msg::TransformStamped> waiting_;  ///< by child frame
  std::int64_t sent_wall_ns_ = 0;
  Time next_ = Time::min();
};

}  // namespace tocsin
