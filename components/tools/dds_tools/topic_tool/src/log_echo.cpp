// SPDX-License-Identifier: Apache-2.0
#include "log_echo.hpp"

#include <chrono>
#include <cstdio>

#include "command_line/stop_signal.hpp"
#include "foundation/printable.hpp"
#include "foundation/ros_names.hpp"
#include "idl_support/decode.hpp"
#include "topic_session.hpp"

namespace tocsin::topic_tool {
namespace {

/// Between two looks at a log that had nothing new.
constexpr Duration log_period = std::chrono::milliseconds(20);
/// Samples between two commits.
constexpr std::size_t at_once = 100;

std::int64_t wall_now_ns() {
  return std::chrono::nanoseconds(std::chrono::system_clock::now().time_since_epoch()).count();
}

}  // namespace

bool print(const TypeInfo& type, const std::vector<std::uint8_t>& bytes, const EchoOptions& shown) {
  const auto message = decode(type, bytes);
  if (!message) {
    std::fprintf(stderr, "a sample of %zu bytes is no %s\n", bytes.size(),
                 ros_type(type.name).c_str());
    return false;
  }
  std::printf("%s---\n", to_yaml(type, message.get(), shown).c_str());
  std::fflush(stdout);
  return true;
}

LogEcho::LogEcho(const std::string& folder, const std::string& topic, const LogWish& wish)
    : topic_(topic), consumer_(folder, {topic, wish.consumer}, wish.start(wall_now_ns())) {}

void LogEcho::run(const EchoOptions& shown, bool once) {
  while (!is_stopped()) {
    const auto samples = consumer_.read(once ? 1 : at_once);
    if (consumer_.take_gap()) {
      std::fprintf(stderr, "of %s some may be missing here: the log's bounds took them\n",
                   printable(topic_).c_str());
    }
    bool any = false;
    for (const sample_log::LogSample& sample : samples) {
      any |= print(known_type(wire_type(sample.stream->schema.name)), sample.bytes, shown);
    }
    if (!consumer_.commit()) std::fprintf(stderr, "the consumer's place cannot be written\n");
    if (once && any) return;
    if (samples.empty()) sleep_until_stopped(std::chrono::steady_clock::now() + log_period);
  }
}

}  // namespace tocsin::topic_tool
