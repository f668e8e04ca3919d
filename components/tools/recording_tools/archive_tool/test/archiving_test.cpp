// SPDX-License-Identifier: Apache-2.0
#include "archiving.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "small_bag.hpp"

namespace tocsin::archive {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class ArchivingTest : public ::testing::Test {
 protected:
  ArchivingTest() { make_run(runs_ / "1"); }
  Round sync() { return archive({runs_}, *store_, index_); }
  [[nodiscard]] fs::path stored(const Recording& one) const { return store_path_ / object_of(one); }

  TemporaryFolder folder_;
  const fs::path runs_ = fs::path(folder_.path()) / "runs";
  const fs::path store_path_ = fs::path(folder_.path()) / "archive";
  std::unique_ptr<ObjectStore> store_ = open_store(store_path_, {});
  RecordingIndex index_{open_database(folder_.path() + "/index.sqlite")};
};

TEST_F(ArchivingTest, EachRecordingIsInStoreAndIndexOnce) {
  EXPECT_EQ(sync().added, 2U);
  EXPECT_EQ(sync().added, 0U);
  EXPECT_EQ(sync().known, 2U);
  EXPECT_EQ(index_.files({}).size(), 2U);
  EXPECT_EQ(index_.readings({}).size(), 10U) << "of both sides together";
  for (const Recording& one : closed_recordings({runs_})) {
    EXPECT_EQ(content_of(stored(one)), content_of(one.path));
  }
  make_run(runs_ / "2", noon_ns + 1000 * second_ns);
  EXPECT_EQ(sync().added, 2U);
}

TEST_F(ArchivingTest, WhatWasStoredBeforeAKillIsIndexedLater) {
  const auto all = closed_recordings({runs_});
  put_text(stored(all[0]), "half of it, by a process that was killed");
  EXPECT_EQ(sync().added, 2U);
  EXPECT_EQ(content_of(stored(all[0])), content_of(all[0].path));
}

TEST_F(ArchivingTest, WithoutAStoreNothingIsIndexed) {
  put_text(store_path_ / "rover", "a file in the way");
  const Round round = sync();
  EXPECT_EQ(round.added, 0U);
  EXPECT_EQ(round.problems.size(), 2U);
  EXPECT_TRUE(index_.files({}).empty());
  fs::remove(store_path_ / "rover");
  EXPECT_EQ(sync().added, 2U);
}

TEST_F(ArchivingTest, ADamagedRecordingHoldsNoOtherUp) {
  const auto all = closed_recordings({runs_});
  damage(all[0].path);
  const Round round = sync();
  EXPECT_EQ(round.added, 1U);
  ASSERT_EQ(round.problems.size(), 1U);
  EXPECT_THAT(round.problems[0], HasSubstr(all[0].path.string()));
  EXPECT_FALSE(fs::exists(stored(all[0])));
}

TEST_F(ArchivingTest, GivesBackWhatItHas) {
  (void)sync();
  const std::string object = index_.files({}).at(0).object;
  const fs::path to = fs::path(folder_.path()) / "back.mcap";
  store_->get(object, to);
  EXPECT_EQ(content_of(to), content_of(store_path_ / object));
  EXPECT_THROW(store_->get("absent.mcap", fs::path(folder_.path()) / "x"), EnvironmentError);
}

TEST(Places, TheIndexOfAFolderIsInIt) {
  EXPECT_EQ(index_of({"archive", ""}), "archive/index.sqlite");
  EXPECT_EQ(index_of({"s3://bucket", "postgresql://host/db"}), "postgresql://host/db");
  EXPECT_THROW((void)index_of({"s3://bucket", ""}), ConfigError);
}

TEST(Stores, RefuseABucketWithoutNameOrKeys) {
  EXPECT_THROW((void)open_store("s3://", {"", "us-east-1", "key", "secret"}), ConfigError);
  EXPECT_THROW((void)open_store("s3://bucket", {"", "us-east-1", "", ""}), ConfigError);
}

TEST(Stores, NameABucketThatDoesNotAnswer) {
  const TemporaryFolder folder;
  const auto sut =
      open_store("s3://bucket/p", {"http://127.0.0.1:1", "us-east-1", "key", "secret"});
  put_text(folder.path() + "/x.mcap", "x");
  try {
    sut->put("x.mcap", folder.path() + "/x.mcap");
    FAIL();
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstr("bucket http://127.0.0.1:1/bucket/p/x.mcap"));
  }
}

}  // namespace
}  // namespace tocsin::archive
