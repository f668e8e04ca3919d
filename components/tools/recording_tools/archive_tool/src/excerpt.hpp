// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace tocsin::archive {

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

/// What a recording has of a topic.
struct TopicExcerpt {
  std::string topic;  ///< `/odom`
  std::string type;   ///< `nav_msgs/msg/Odometry`
  std::int64_t messages = 0;
  std::int64_t from_ns = 0;  ///< [ns] since the Unix epoch, when the first was received
  std::int64_t to_ns = 0;    ///< the last
  std::int64_t gaps = 0;     ///< messages that a writer sent and that are not there
};

/// Plain numbers of one second; NaN where nothing was told.
struct Reading {
  std::int64_t time_ns = 0;  ///< [ns] since the Unix epoch, when the link was measured
  double x_m = not_known;    ///< place, map frame, told at most 2 s before
  double y_m = not_known;
  double signal_dbm = not_known;
  double loss_percent = not_known;  ///< of probes
  double qni = not_known;           ///< [0, 100] network quality index
  double battery_percent = not_known;
};

/// What an index keeps of a recording.
struct Excerpt {
  std::int64_t from_ns = 0;  ///< [ns] since the Unix epoch, of the first message; 0: there is none
  std::int64_t to_ns = 0;
  std::vector<TopicExcerpt> topics;  ///< by name
  std::vector<Reading> readings;     ///< one for each network_quality, by time
};

/// Reads the whole file. Throws ConfigError when it is no MCAP file, or a part of it is damaged.
[[nodiscard]] Excerpt excerpt_of(const std::string& path);

}  // namespace tocsin::archive
