// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "idl_support/type_info.hpp"
#include "log_places.hpp"
#include "message_yaml.hpp"
#include "sample_log/consumer.hpp"

namespace tocsin::topic_tool {

/// Prints a message, and the line that ends it. False, and a line to stderr: the bytes are none.
bool print(const TypeInfo& type, const std::vector<std::uint8_t>& bytes, const EchoOptions& shown);

/// Prints a topic of a log, the old first, then what comes.
class LogEcho {
 public:
  /// Throws like sample_log::Consumer.
  LogEcho(const std::string& folder, const std::string& topic, const LogWish& wish);

  /// Until a signal comes; with `once` until one message was printed. Throws ConfigError when the
  /// type is not known here.
  void run(const EchoOptions& shown, bool once);

 private:
  const std::string topic_;
  sample_log::Consumer consumer_;
};

}  // namespace tocsin::topic_tool
