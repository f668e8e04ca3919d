// SPDX-License-Identifier: Apache-2.0
#include "info_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <ctime>
#include <filesystem>

#include "foundation/temporary_folder.hpp"
#include "tool_bags.hpp"

namespace tocsin::bag_tool {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class InfoText : public ::testing::Test {
 protected:
  InfoText() {
    setenv("TZ", "UTC", 1);
    tzset();
  }
  const TemporaryFolder folder;
};

TEST_F(InfoText, IsThatOfRos2Bag) {
  write_bag(folder.path("run"), {"/a", "/b"}, 3);
  const bag::BagReader reader(folder.path("run"));
  EXPECT_EQ(info_text(reader),
            "\nFiles:             run_0.mcap\n"
            "Bag size:          " +
                size_text(reader.size()) +
                "\n"
                "Storage id:        mcap\n"
                "Duration:          2.000000000s\n"
                "Start:             Nov 14 2023 22:13:20.000000000 (1700000000.000000000)\n"
                "End:               Nov 14 2023 22:13:22.000000000 (1700000002.000000000)\n"
                "Messages:          6\n"
                "Topic information: Topic: /a | Type: std_msgs/msg/String | Count: 3 | "
                "Serialization Format: cdr\n"
                "                   Topic: /b | Type: std_msgs/msg/String | Count: 3 | "
                "Serialization Format: cdr\n");
}

TEST_F(InfoText, OfAnEmptyBagHasNoTopics) {
  write_bag(folder.path("run"), {}, 0);
  const std::string text = info_text(bag::BagReader(folder.path("run")));
  EXPECT_THAT(text, HasSubstr("Messages:          0\nTopic information: \n"));
  EXPECT_THAT(text, Not(HasSubstr("Damaged")));
}

TEST_F(InfoText, SaysWhatAFileLacks) {
  write_bag(folder.path("run"), {"/a"}, 3);
  const std::string path = folder.path("run/run_0.mcap");
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 1);
  EXPECT_THAT(
      info_text(bag::BagReader(folder.path("run"))),
      HasSubstr("Damaged:           run_0.mcap has no summary; tocsin bag recover mends it"));
}

TEST_F(InfoText, ShowsNoControlCharactersOfAFile) {
  write_bag(folder.path("run"), {"/a\x1b[2J"}, 1);
  EXPECT_THAT(info_text(bag::BagReader(folder.path("run"))), HasSubstr("Topic: /a\\x1b[2J |"));
}

TEST(SizeText, HasTheUnitsOfRos2Bag) {
  EXPECT_EQ(size_text(0), "0 B");
  EXPECT_EQ(size_text(1023), "1023 B");
  EXPECT_EQ(size_text(1024), "1.0 KiB");
  EXPECT_EQ(size_text(1'300'000), "1.2 MiB");
  EXPECT_EQ(size_text(10'000'000'000), "9.3 GiB");
  EXPECT_EQ(size_text(std::uint64_t{1} << 60U), "1048576.0 TiB");
}

TEST(DamageText, NamesEveryFault) {
  mcap::Damage damage;
  EXPECT_EQ(damage_text(damage), "");
  damage.chunks = 2;
  damage.messages = 3;
  EXPECT_EQ(damage_text(damage),
            "2 chunks are damaged, 3 messages are of channels that nobody declared");
}

}  // namespace
}  // namespace tocsin::bag_tool
