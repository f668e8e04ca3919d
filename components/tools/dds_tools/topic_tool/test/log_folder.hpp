// SPDX-License-Identifier: Apache-2.0
// A log of texts in a folder, as a router writes it.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "idl_support/encode.hpp"
#include "idl_support/type_info.hpp"
#include "ros_idl/std_msgs.hpp"
#include "sample_log/sample_log.hpp"

namespace tocsin::topic_tool {

class TextLog {
 public:
  using Message = std_msgs::msg::String;

  TextLog(const std::string& folder, const std::string& topic)
      : files_(folder),
        log_(files_, {}, Instant{now_, wall_now_ns()}, sample_log::LogUse::history),
        stream_(sample_log::stream_key(topic)) {
    log_.add({topic, topic, {0, "std_msgs/msg/String", "", ""}, {}});
  }
  void write(const std::vector<std::string>& texts) {
    for (const std::string& text : texts) {
      Message message;
      message.data(text);
      (void)log_.append({{{stream_, 7, ++last_}, 1000, encode(type_info<Message>(), &message)}},
                        {now_, wall_now_ns()});
    }
  }

 private:
  static std::int64_t wall_now_ns() {
    return std::chrono::nanoseconds(std::chrono::system_clock::now().time_since_epoch()).count();
  }
  const Time now_{std::chrono::hours(1)};
  sample_log::FolderFiles files_;
  sample_log::SampleLog log_;
  const std::uint64_t stream_;
  std::uint64_t last_ = 0;
};

}  // namespace tocsin::topic_tool
