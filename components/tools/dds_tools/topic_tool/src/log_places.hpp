// SPDX-License-Identifier: Apache-2.0
// What of a log a person wants to see, and where logs are.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sample_log/log_follower.hpp"

namespace tocsin::deployment {
struct RunningHost;
}

namespace tocsin::topic_tool {

struct LogWish {
  std::optional<std::uint64_t> last;
  std::optional<double> since_s;
  bool from_start = false;
  std::string consumer;  ///< empty: none that is remembered
  std::string folder;    ///< the router's store_directory; empty: of the running host

  /// Whether the log is to be read at all.
  [[nodiscard]] bool is_wanted() const {
    return last || since_s || from_start || !consumer.empty() || !folder.empty();
  }
  /// `wall_ns` [ns] since the Unix epoch, of now.
  [[nodiscard]] sample_log::LogStart start(std::int64_t wall_ns) const;
};

/// The folder of the router's stored topics on a host. `vehicle`: whose router at a station that
/// serves several.
[[nodiscard]] std::string store_folder(const deployment::RunningHost& host,
                                       const std::string& vehicle = "");
/// The logs in that folder: of stored topics, and the history of logged and kept ones.
[[nodiscard]] std::vector<std::string> folders_in(const std::string& store);
/// The first of the folders whose log has samples of the topic, with its slash. Waits for one at
/// most `patience`; throws ConfigError when there is none.
[[nodiscard]] std::string folder_with(const std::vector<std::string>& folders,
                                      const std::string& topic, Duration patience);

}  // namespace tocsin::topic_tool
