// SPDX-License-Identifier: Apache-2.0
// What the authors of the format read in our files: @mcap/core, by test/mcap_peer. Skipped where it
// was not installed (npm ci in that folder).
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "foundation/temporary_folder.hpp"
#include "mcap_files.hpp"

namespace tocsin::mcap {
namespace {

const std::string peer = TOCSIN_REPOSITORY "/test/mcap_peer";

std::optional<std::string> output_of(const std::string& command) {
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  std::string text;
  std::array<char, 4096> part{};
  while (pipe && fgets(part.data(), static_cast<int>(part.size()), pipe.get()) != nullptr) {
    text += part.data();
  }
  if (text.empty()) return std::nullopt;
  return text;
}

class PeerReads : public ::testing::TestWithParam<Compression> {};
INSTANTIATE_TEST_SUITE_P(Each, PeerReads,
                         ::testing::Values(Compression::none, Compression::lz4, Compression::zstd));

TEST_P(PeerReads, AllThatWeWrite) {
  if (!std::filesystem::exists(peer + "/node_modules/@mcap/core")) {
    GTEST_SKIP() << "@mcap/core is not installed: npm ci in test/mcap_peer";
  }
  if (!output_of("node --version 2>/dev/null")) GTEST_SKIP() << "there is no node";
  const TemporaryFolder folder;
  {
    FileSink sink(folder.path("ours.mcap"));
    TwoTopics file(sink, small_chunks(GetParam()));
    (void)file.writer.write(Attachment{1, 2, "map.pgm", "image/x-pgm", "P5"});
    for (std::uint32_t i = 0; i < 301; ++i) {
      std::string int32{0, 1, 0, 0};
      for (unsigned k = 0; k < 4; ++k) int32 += static_cast<char>(i >> (8 * k));
      (void)file.write({i % 3 == 0 ? "/a" : "/b", i, 1'700'000'000'000'000'000U + i, int32});
    }
    (void)file.writer.write(Metadata{"run", {{"seed", "3"}}});
  }
  const auto text = output_of("node " + peer + "/read_file.mjs " + folder.path("ours.mcap"));
  ASSERT_TRUE(text);
  const auto said = nlohmann::json::parse(*text);
  EXPECT_EQ(said["profile"], "ros2");
  EXPECT_EQ(said["topics"]["/a"], 101);
  EXPECT_EQ(said["topics"]["/b"], 200);
  EXPECT_EQ(said["streamed"], 301);
  EXPECT_EQ(said["counted"], 301);
  EXPECT_EQ(said["decoded"], 301);
  EXPECT_EQ(said["schemas"][0], "p/msg/T ros2msg");
  EXPECT_EQ(said["attachments"]["map.pgm"], "P5");
  EXPECT_EQ(said["metadata"]["run"]["seed"], "3");
}

}  // namespace
}  // namespace tocsin::mcap
