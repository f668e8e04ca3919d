// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bag/topic.hpp"

namespace tocsin::bag {

inline constexpr const char* metadata_file = "metadata.yaml";

/// What metadata.yaml says: version 5 of rosbag2, which Humble and all later releases read.
struct Metadata {
  struct TopicCount {
    Topic topic;
    std::uint64_t count = 0;
  };
  struct File {
    std::string path;  ///< relative to the folder
    std::int64_t start_ns = 0;
    std::int64_t duration_ns = 0;
    std::uint64_t count = 0;
  };
  std::int64_t start_ns = 0;  ///< since the Unix epoch; 0: there is no message
  std::int64_t duration_ns = 0;
  std::uint64_t count = 0;
  std::vector<TopicCount> topics;
  std::vector<File> files;
};

[[nodiscard]] std::string to_yaml(const Metadata& metadata);

/// The files of a bag, relative to its folder, as metadata.yaml of any version names them; the rest
/// stands in the files themselves. `name` stands in front of errors. Throws ConfigError when it is
/// no such text, names another storage than mcap, files that were packed whole, or files elsewhere.
[[nodiscard]] std::vector<std::string> files_in_metadata(const std::string& text,
                                                         const std::string& name);

}  // namespace tocsin::bag
