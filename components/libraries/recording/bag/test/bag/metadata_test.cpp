// SPDX-License-Identifier: Apache-2.0
#include "bag/metadata.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bags.hpp"
#include "foundation/error.hpp"

namespace tocsin::bag {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

Metadata example() {
  Metadata metadata;
  metadata.start_ns = t0;
  metadata.duration_ns = 5;
  metadata.count = 3;
  metadata.topics.push_back({text_topic("/chatter"), 3});
  metadata.files.push_back({"run_0.mcap", t0, 5, 3});
  return metadata;
}

TEST(Metadata, HasTheFieldsOfVersion5OfRosbag2) {
  EXPECT_EQ(to_yaml(example()),
            "rosbag2_bagfile_information:\n"
            "  version: 5\n"
            "  storage_identifier: mcap\n"
            "  duration:\n"
            "    nanoseconds: 5\n"
            "  starting_time:\n"
            "    nanoseconds_since_epoch: 1700000000000000000\n"
            "  message_count: 3\n"
            "  topics_with_message_count:\n"
            "    - topic_metadata:\n"
            "        name: /chatter\n"
            "        type: std_msgs/msg/String\n"
            "        serialization_format: cdr\n"
            "        offered_qos_profiles: \"- history: 3\\n  depth: 0\\n  reliability: 1\\n"
            "  durability: 2\\n  deadline:\\n    sec: 9223372036\\n    nsec: 854775807\\n"
            "  lifespan:\\n    sec: 9223372036\\n    nsec: 854775807\\n  liveliness: 1\\n"
            "  liveliness_lease_duration:\\n    sec: 9223372036\\n    nsec: 854775807\\n"
            "  avoid_ros_namespace_conventions: false\"\n"
            "      message_count: 3\n"
            "  compression_format: \"\"\n"
            "  compression_mode: \"\"\n"
            "  relative_file_paths:\n"
            "    - run_0.mcap\n"
            "  files:\n"
            "    - path: run_0.mcap\n"
            "      starting_time:\n"
            "        nanoseconds_since_epoch: 1700000000000000000\n"
            "      duration:\n"
            "        nanoseconds: 5\n"
            "      message_count: 3\n");
}

TEST(Metadata, OfABagWithoutMessagesHasEmptyLists) {
  const std::string text = to_yaml(Metadata{});
  EXPECT_THAT(text, HasSubstr("topics_with_message_count:\n    []\n"));
  EXPECT_TRUE(files_in_metadata(text, "metadata.yaml").empty());
}

TEST(Metadata, NamesItsFiles) {
  Metadata metadata = example();
  metadata.files.push_back({"run_1.mcap", t0 + 6, 0, 0});
  EXPECT_THAT(files_in_metadata(to_yaml(metadata), "metadata.yaml"),
              ElementsAre("run_0.mcap", "run_1.mcap"));
}

/// The error of a text in which `from` stands for `to`.
std::string error_of(const std::string& from, const std::string& to) {
  std::string text = to_yaml(example());
  text.replace(text.find(from), from.size(), to);
  try {
    (void)files_in_metadata(text, "x/metadata.yaml");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

TEST(Metadata, RefusesWhatCannotBeRead) {
  EXPECT_THAT(
      error_of("storage_identifier: mcap", "storage_identifier: sqlite3"),
      HasSubstr("x/metadata.yaml: storage_identifier: 'sqlite3' cannot be read, only mcap"));
  EXPECT_THAT(error_of("compression_mode: \"\"", "compression_mode: FILE"),
              HasSubstr("compression_mode: 'FILE' cannot be read"));
  EXPECT_THAT(error_of("rosbag2_bagfile_information:", "other:"),
              HasSubstr("has no map rosbag2_bagfile_information"));
  EXPECT_THAT(error_of("    - run_0.mcap\n", "    7\n"), HasSubstr("is not a list of files"));
}

TEST(Metadata, RefusesFilesElsewhere) {
  for (const std::string path : {"/etc/passwd", "../other/x.mcap", "..", "", "[a]"}) {
    EXPECT_THAT(error_of("    - run_0.mcap\n", "    - " + (path.empty() ? "\"\"" : path) + "\n"),
                HasSubstr("is not the name of a file in the bag's folder"))
        << path;
  }
}

}  // namespace
}  // namespace tocsin::bag
