// SPDX-License-Identifier: Apache-2.0
#include "bag/recover_bag.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "bags.hpp"
#include "foundation/error.hpp"

namespace tocsin::bag {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// A bag of three files, the last of which was cut in its summary.
void write_cut_bag(const std::string& folder) {
  BagOptions options;
  options.max_duration_s = 2;
  write_bag(folder, 5, options);
  const std::string last = folder + "/run_2.mcap";
  fs::resize_file(last, fs::file_size(last) - 20);
}

TEST(RecoverBag, MakesAWholeBagOfOneThatWasCut) {
  const TemporaryFolder folder;
  write_cut_bag(folder.path("run"));
  const auto recovered = recover_bag(folder.path("run"), folder.path("mended"));
  ASSERT_EQ(recovered.size(), 3U);
  EXPECT_FALSE(recovered[0].recovered.damage.no_summary);
  EXPECT_EQ(recovered[2].name, "run_2.mcap");
  EXPECT_EQ(recovered[2].recovered.messages, 1U);
  BagReader mended(folder.path("mended"));
  EXPECT_TRUE(mended.damaged().empty());
  BagReader cut(folder.path("run"));
  EXPECT_EQ(all_of(mended), all_of(cut));
  EXPECT_THAT(folder.read("mended/metadata.yaml"), HasSubstr("message_count: 5"));
}

TEST(RecoverBag, TakesAllFilesThoughMetadataIsMissingOrOld) {
  const TemporaryFolder folder;
  write_cut_bag(folder.path("run"));
  folder.write("run/metadata.yaml", "nonsense");
  EXPECT_EQ(recover_bag(folder.path("run"), folder.path("mended")).size(), 3U);
  EXPECT_EQ(BagReader(folder.path("mended")).about().count, 5U);
}

TEST(RecoverBag, GoesOnPastAFileThatAPowerCutLeftEmpty) {
  const TemporaryFolder folder;
  write_cut_bag(folder.path("run"));
  fs::resize_file(folder.path("run/run_1.mcap"), 0);
  const auto recovered = recover_bag(folder.path("run"), folder.path("mended"));
  EXPECT_EQ(recovered.at(1).recovered.damage.cut_at, 0U);
  EXPECT_EQ(BagReader(folder.path("mended")).about().count, 3U);
}

TEST(RecoverBag, TakesOneFileAlone) {
  const TemporaryFolder folder;
  write_cut_bag(folder.path("run"));
  (void)recover_bag(folder.path("run/run_2.mcap"), folder.path("mended"));
  EXPECT_EQ(BagReader(folder.path("mended")).about().count, 1U);
}

TEST(RecoverBag, RefusesAFolderThatIsThereAndOneWithoutMcap) {
  const TemporaryFolder folder;
  write_cut_bag(folder.path("run"));
  folder.write("taken/x", "precious");
  EXPECT_THROW((void)recover_bag(folder.path("run"), folder.path("taken")), ConfigError);
  EXPECT_EQ(folder.read("taken/x"), "precious");
  EXPECT_THROW((void)recover_bag(folder.path("taken"), folder.path("mended")), ConfigError);
  EXPECT_FALSE(fs::exists(folder.path("mended")));
}

}  // namespace
}  // namespace tocsin::bag
