// SPDX-License-Identifier: Apache-2.0
// Files that @mcap/core 2.2.2 wrote (test/mcap_peer/write_files.mjs), all with the same content.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "mcap/recovery.hpp"
#include "mcap_files.hpp"

namespace tocsin::mcap {
namespace {

const std::filesystem::path files = TOCSIN_SOURCE_DIR "/test/mcap/files";

std::vector<Sent> expected() {
  std::vector<Sent> messages;
  for (std::uint32_t i = 0; i < 20; ++i) {
    const std::string one = "message " + std::to_string(i) + " ";
    const std::string text = one + one + one + one;
    const std::string head{0, 1, 0, 0, static_cast<char>(text.size() + 1), 0, 0, 0};
    messages.push_back({i % 2 == 0 ? "/left" : "/right", i, 1000 + 10 * i, head + text + '\0'});
  }
  return messages;
}

struct Foreign {
  const char* name;
  bool has_summary;  ///< one that tells where the messages are
};
void PrintTo(const Foreign& file, std::ostream* to) { *to << file.name; }

class ForeignFile : public ::testing::TestWithParam<Foreign> {
 protected:
  const std::string path = files / (std::string(GetParam().name) + ".mcap");
};
INSTANTIATE_TEST_SUITE_P(Each, ForeignFile,
                         ::testing::Values(Foreign{"none", true}, Foreign{"zstd", true},
                                           Foreign{"lz4", true}, Foreign{"no_chunks", false},
                                           Foreign{"no_indexes", false},
                                           Foreign{"unknown_records", false}));

TEST_P(ForeignFile, IsReadWhole) {
  Reader reader(path);
  EXPECT_EQ(reader.damage().no_summary, !GetParam().has_summary);
  EXPECT_EQ(reader.damage().cut_at, std::nullopt);
  const Summary& summary = reader.summary();
  EXPECT_EQ(summary.header.profile, "ros2");
  EXPECT_EQ(summary.header.library, "@mcap/core");
  EXPECT_EQ(summary.statistics.message_count, 20U);
  EXPECT_EQ(summary.statistics.start_ns, 1000U);
  EXPECT_EQ(summary.statistics.end_ns, 1190U);
  ASSERT_EQ(summary.schemas.size(), 1U);
  EXPECT_EQ(summary.schemas.begin()->second.data, "string data\n");
  ASSERT_EQ(summary.channels.size(), 2U);
  EXPECT_EQ(summary.channels.begin()->second.metadata.at("offered_qos_profiles"), "/left");
  EXPECT_EQ(all_of(reader), expected());
  ASSERT_EQ(summary.attachments.size(), 1U);
  EXPECT_EQ(reader.read(summary.attachments[0])->data, "P5 1 1 255 x");
  ASSERT_EQ(summary.metadata.size(), 1U);
  EXPECT_EQ(reader.read(summary.metadata[0])->values.at("seed"), "3");
}

/// Files of others, for example of rosbag2, when there are some on this computer.
TEST(SharedFiles, AreReadWhole) {
  const char* const shared = std::getenv("TOCSIN_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "no $TOCSIN_SHARED";
  std::size_t found = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator(shared)) {
    if (file.path().extension() != ".mcap") continue;
    ++found;
    Reader reader(file.path());
    EXPECT_EQ(all_of(reader).size(), reader.summary().statistics.message_count) << file.path();
    EXPECT_EQ(reader.damage().chunks, 0U) << file.path();
  }
  if (found == 0) GTEST_SKIP() << shared << " has no MCAP file";
}

}  // namespace
}  // namespace tocsin::mcap
