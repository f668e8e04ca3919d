// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <tuple>
#include <vector>

#include "bag/bag_reader.hpp"
#include "bag/bag_writer.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::bag {

/// A time of day in 2023 [ns] and what comes after it.
inline constexpr std::int64_t t0 = 1'700'000'000'000'000'000;
inline constexpr std::int64_t second = 1'000'000'000;

inline Topic text_topic(const std::string& name) {
  Topic topic;
  topic.name = name;
  topic.type = "std_msgs/msg/String";
  topic.definition_encoding = "ros2msg";
  topic.definition = "string data\n";
  topic.offered_qos.emplace_back();
  return topic;
}

inline Message message_of(std::uint32_t sequence, std::int64_t log_time_ns,
                          const std::string& data) {
  return {sequence, log_time_ns, log_time_ns - 1000,
          reinterpret_cast<const std::uint8_t*>(data.data()), data.size()};
}

/// What a reader gives: topic, sequence, log time, bytes.
using Got = std::tuple<std::string, std::uint32_t, std::int64_t, std::string>;

inline std::vector<Got> all_of(BagReader& reader, const Selection& selection = {}) {
  std::vector<Got> all;
  const auto stream = reader.messages(selection);
  while (const auto one = stream->next()) {
    const Message& message = one->message;
    all.emplace_back(reader.topics().at(one->topic).topic.name, message.sequence,
                     message.log_time_ns,
                     std::string(reinterpret_cast<const char*>(message.data), message.size));
  }
  return all;
}

/// A bag of `count` messages of /chatter, one a second from t0.
inline void write_bag(const std::string& folder, std::uint32_t count,
                      const BagOptions& options = {}) {
  BagWriter writer(folder, options);
  const std::size_t chatter = writer.add(text_topic("/chatter"));
  for (std::uint32_t i = 0; i < count; ++i) {
    (void)writer.write(chatter, message_of(i, t0 + i * second, "text " + std::to_string(i)));
  }
}

}  // namespace tocsin::bag
