// SPDX-License-Identifier: Apache-2.0
#include "operator_server/bag_list.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "foundation/temporary_folder.hpp"
#include "mcap/byte_sink.hpp"
#include "mcap/writer.hpp"

namespace tocsin::foxglove {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class BagListTest : public ::testing::Test {
 protected:
  /// A file with two messages, at 100 s and 107.5 s.
  void write_bag(const std::string& name, bool closed = true) const {
    fs::create_directories(fs::path(folder_.path(name)).parent_path());
    mcap::FileSink file(folder_.path(name));
    mcap::Writer writer(file, {});
    const auto schema =
        writer.declare(mcap::Schema{0, "std_msgs/msg/Bool", "ros2msg", "bool data"});
    const auto channel = writer.declare(mcap::Channel{0, schema.value_or(0), "/lamp", "cdr", {}});
    const std::uint8_t byte = 1;
    for (const std::uint64_t at : {100'000'000'000U, 107'500'000'000U}) {
      (void)writer.write(mcap::Message{channel.value_or(0), 1, at, at, &byte, 1});
    }
    (void)writer.close();
    // Whose writer has not come to the end yet.
    if (!closed) fs::resize_file(folder_.path(name), fs::file_size(folder_.path(name)) - 20);
  }
  void make_older(const std::string& name, int seconds) const {
    fs::last_write_time(folder_.path(name),
                        fs::last_write_time(folder_.path(name)) - std::chrono::seconds(seconds));
  }
  [[nodiscard]] std::vector<std::string> paths() const {
    std::vector<std::string> all;
    for (const ListedBag& bag : list_bags(folder_.path())) all.push_back(bag.path);
    return all;
  }
  const TemporaryFolder folder_;
};

TEST_F(BagListTest, NamesTheFilesOfAllFoldersTheNewestFirst) {
  write_bag("gcs/bag/bag_0.mcap");
  write_bag("gcs/operator/bag/bag_0.mcap");
  write_bag("uxv/bag/bag_0.mcap");
  (void)folder_.write("gcs/messages.csv", "receive_s\n");
  make_older("gcs/bag/bag_0.mcap", 20);
  make_older("uxv/bag/bag_0.mcap", 10);
  EXPECT_THAT(paths(), ElementsAre("gcs/operator/bag/bag_0.mcap", "uxv/bag/bag_0.mcap",
                                   "gcs/bag/bag_0.mcap"));
}

TEST_F(BagListTest, SaysTimeAndSizeOfABagThatIsClosed) {
  write_bag("bag_0.mcap");
  const auto bags = list_bags(folder_.path());
  ASSERT_EQ(bags.size(), 1U);
  EXPECT_EQ(bags[0].bytes, fs::file_size(folder_.path("bag_0.mcap")));
  ASSERT_TRUE(bags[0].span);
  EXPECT_EQ(bags[0].span->begin_ns, 100'000'000'000);
  EXPECT_EQ(bags[0].span->end_ns, 107'500'000'000);
  EXPECT_EQ(bags[0].span->messages, 2U);
}

TEST_F(BagListTest, ABagThatIsStillWrittenHasNoSpan) {
  write_bag("open.mcap", false);
  (void)folder_.write("no_bag.mcap", "\x89MCAP0\r\n lies \x89MCAP0\r\n");
  (void)folder_.write("empty.mcap", "");
  const auto bags = list_bags(folder_.path());
  ASSERT_EQ(bags.size(), 3U);
  for (const ListedBag& bag : bags) EXPECT_FALSE(bag.span) << bag.path;
}

TEST_F(BagListTest, ListsNeitherLinksNorNamesThatARequestCannotHave) {
  const TemporaryFolder other;
  (void)other.write("secret.mcap", "x");
  fs::create_symlink(other.path("secret.mcap"), folder_.path("link.mcap"));
  fs::create_directory_symlink(other.path(), folder_.path("linked"));
  (void)folder_.write("with space.mcap", "x");
  (void)folder_.write(".hidden/bag.mcap", "x");
  (void)folder_.write("a/b/c/d/e/too_deep.mcap", "x");
  (void)folder_.write("a/b/c/d/deep.mcap", "x");
  EXPECT_THAT(paths(), ElementsAre("a/b/c/d/deep.mcap"));
}

TEST_F(BagListTest, AnEmptyOrAbsentFolderHasNone) {
  EXPECT_THAT(paths(), IsEmpty());
  EXPECT_THAT(list_bags(""), IsEmpty());
  EXPECT_THAT(list_bags("/no/such/folder"), IsEmpty());
}

TEST_F(BagListTest, NoMoreThan200AreListed) {
  for (int i = 0; i < 210; ++i) (void)folder_.write(std::to_string(i) + ".mcap", "x");
  EXPECT_EQ(paths().size(), 200U);
}

TEST_F(BagListTest, OpensWhatIsListedAndNothingElse) {
  const TemporaryFolder other;
  (void)other.write("secret.mcap", "x");
  (void)folder_.write("gcs/bag_0.mcap", "12345");
  (void)folder_.write("gcs/messages.csv", "x");
  fs::create_symlink(other.path("secret.mcap"), folder_.path("gcs/link.mcap"));
  fs::create_directory_symlink(other.path(), folder_.path("linked"));
  fs::create_directory(folder_.path("folder.mcap"));
  const OpenBag open = open_bag(folder_.path(), "gcs/bag_0.mcap");
  EXPECT_TRUE(open.file);
  EXPECT_EQ(open.bytes, 5U);
  for (const char* path : {"gcs/messages.csv", "gcs/link.mcap", "linked/secret.mcap", "folder.mcap",
                           "gcs/none.mcap", "", "/etc/passwd", "../gcs/bag_0.mcap",
                           "gcs/../../secret.mcap", "gcs//bag_0.mcap", "gcs/bag_0.mcap/x.mcap"}) {
    EXPECT_FALSE(open_bag(folder_.path(), path).file) << path;
  }
  EXPECT_FALSE(open_bag("", "gcs/bag_0.mcap").file);
}

TEST_F(BagListTest, IsToldAsJson) {
  const std::string text =
      to_json({{"gcs/bag_0.mcap", 10, ListedBag::Span{1'500'000'000, 3'000'000'000, 7}},
               {"gcs/open.mcap", 20, std::nullopt}});
  const auto said = nlohmann::json::parse(text).at("bags");
  EXPECT_EQ(said[0], (nlohmann::json{{"path", "gcs/bag_0.mcap"},
                                     {"bytes", 10},
                                     {"begin_s", 1.5},
                                     {"end_s", 3.0},
                                     {"messages", 7}}));
  EXPECT_EQ(said[1], (nlohmann::json{{"path", "gcs/open.mcap"}, {"bytes", 20}}));
  EXPECT_EQ(to_json({}), R"({"bags":[]})");
}

struct RangeCase {
  const char* header;
  std::uint64_t first;
  std::uint64_t length;
  bool is_part;
};

TEST(ByteRangeTest, IsThatOfTheStandard) {
  for (const RangeCase& one : std::vector<RangeCase>{{"", 0, 10, false},
                                                     {"bytes=0-9", 0, 10, true},
                                                     {"bytes=2-4", 2, 3, true},
                                                     {"bytes=9-9", 9, 1, true},
                                                     {"bytes=2-", 2, 8, true},
                                                     {"bytes=2-99", 2, 8, true},
                                                     {"bytes=-3", 7, 3, true},
                                                     {"bytes=-99", 0, 10, true},
                                                     {"bytes=4-2", 0, 10, false},
                                                     {"bytes=0-1,3-4", 0, 10, false},
                                                     {"bytes=-", 0, 10, false},
                                                     {"bytes=a-b", 0, 10, false},
                                                     {"bytes=+1-2", 0, 10, false},
                                                     {"lines=0-1", 0, 10, false}}) {
    const auto range = byte_range(one.header, 10);
    ASSERT_TRUE(range) << one.header;
    EXPECT_EQ(range->first, one.first) << one.header;
    EXPECT_EQ(range->length, one.length) << one.header;
    EXPECT_EQ(range->is_part, one.is_part) << one.header;
  }
}

TEST(ByteRangeTest, HasNoBytesBehindTheEnd) {
  for (const char* header : {"bytes=10-", "bytes=10-12", "bytes=99-", "bytes=-0"}) {
    EXPECT_FALSE(byte_range(header, 10)) << header;
  }
  EXPECT_FALSE(byte_range("bytes=0-", 0));
  EXPECT_EQ(byte_range("", 0)->length, 0U);
  EXPECT_EQ(byte_range("bytes=18446744073709551615-18446744073709551616", 10)->length, 10U);
}

}  // namespace
}  // namespace tocsin::foxglove
