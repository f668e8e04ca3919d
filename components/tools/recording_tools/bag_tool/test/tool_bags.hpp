// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "bag/bag_writer.hpp"

namespace tocsin::bag_tool {

inline constexpr std::int64_t t0 = 1'700'000'000'000'000'000;
inline constexpr std::int64_t second = 1'000'000'000;

/// A bag of one message a second of each topic, the topics in turns, from `start_ns`.
inline void write_bag(const std::string& folder, const std::vector<std::string>& topics,
                      std::uint32_t count, std::int64_t start_ns = t0) {
  bag::BagWriter writer(folder, {});
  std::vector<std::size_t> numbers;
  for (const std::string& name : topics) {
    bag::Topic topic;
    topic.name = name;
    topic.type = "std_msgs/msg/String";
    topic.definition_encoding = "ros2msg";
    topic.definition = "string data\n";
    numbers.push_back(writer.add(topic));
  }
  const std::vector<std::uint8_t> hello{0, 1, 0, 0, 6, 0, 0, 0, 'h', 'e', 'l', 'l', 'o', 0};
  for (std::uint32_t i = 0; i < count; ++i) {
    for (const std::size_t topic : numbers) {
      const std::int64_t time = start_ns + i * second;
      (void)writer.write(topic, {i, time, time, hello.data(), hello.size()});
    }
  }
}

}  // namespace tocsin::bag_tool
