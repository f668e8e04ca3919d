// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "graph_text.hpp"
#include "log_places.hpp"
#include "message_yaml.hpp"
#include "runtime/middleware/qos_policies.hpp"
#include "topic_session.hpp"

namespace tocsin::topic_tool {

/// What a person said after `tocsin topic`.
struct Options : SessionOptions {
  std::string topic;
  std::string type;
  std::string message;
  ListOptions list;
  bool verbose = false;
  EchoOptions echo;
  bool full_length = false;
  bool once = false;
  LogWish log;
  std::size_t window = 10'000;
  double rate_hz = 1;
  int times = 0;
  std::optional<int> wait_readers;  ///< empty: as many as the verb needs
  Reliability reliability = Reliability::reliable;
  Durability durability = Durability::volatile_kind;
};

/// Declares the verbs of `tocsin topic` and their options.
void declare(Verbs& verbs, Options& options);

}  // namespace tocsin::topic_tool
