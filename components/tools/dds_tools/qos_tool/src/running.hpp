// SPDX-License-Identifier: Apache-2.0
// The running system, as the verbs match and set use it.
#pragma once

#include <string>
#include <vector>

#include "live_change.hpp"
#include "qos_options.hpp"

namespace tocsin::qos_tool {

/// `/odom` and `odom` as the host that was chosen has them on the wire.
[[nodiscard]] std::string wire_name(const HostChoice& host, const std::string& topic);

/// All ends of the host that was chosen. Waits until those who are there were heard.
[[nodiscard]] std::vector<GraphEnd> ends_of_host(const Options& options);
/// "; did you mean '/odom'?" with the topics of `ends` that are like `topic`; empty: there are
/// none.
[[nodiscard]] std::string like_running(const std::vector<GraphEnd>& ends, const std::string& topic);

/// What became of a change.
struct Changed {
  int ends = 0;
  int containers = 0;
  std::vector<Pair> stopped;  ///< pairs that do not match now
};
/// Changes the topic `options.one` in all containers of the host, or in none: every one is asked
/// first. Throws ConfigError for what cannot change, EnvironmentError when nobody has the topic.
[[nodiscard]] Changed change_running(const Options& options);

}  // namespace tocsin::qos_tool
