// SPDX-License-Identifier: Apache-2.0
#include "recordings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "small_bag.hpp"

namespace tocsin::archive {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class RecordingsTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<Recording> found() const { return closed_recordings({folder_.path()}); }
  [[nodiscard]] std::filesystem::path in(const std::string& name) const {
    return std::filesystem::path(folder_.path()) / name;
  }
  TemporaryFolder folder_;
};

TEST_F(RecordingsTest, AreOfTheVehicleOfTheirRun) {
  make_run(in("20261129"));
  const auto all = found();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].host, "gcs");
  EXPECT_EQ(all[1].host, "rover");
  for (const Recording& one : all) {
    EXPECT_EQ(one.vehicle, "rover");
    EXPECT_EQ(one.run, "20261129");
    EXPECT_THAT(object_of(one), StartsWith("rover/20261129/" + one.host + "_bag_0-"));
  }
  EXPECT_NE(all[0].id, all[1].id);
}

TEST_F(RecordingsTest, OfAFleetEachIsOfItsVehicle) {
  put_text(in("run/deployment.yaml"), "hosts: {}\n");
  make_run(in("run/uxv3"));
  const auto all = found();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].vehicle, "uxv3");
  EXPECT_EQ(all[0].run, "run");
  EXPECT_EQ(all[0].host, "gcs");
}

TEST_F(RecordingsTest, OfNoRunAreOfAnUnknownVehicle) {
  {
    SmallBag bag(in("mine"));
    bag.drive(2);
  }
  put_text(in("foreign/deployment.yaml"), "hosts: [\n");
  {
    SmallBag bag(in("foreign/host/bag"));
    bag.drive(3);
  }
  const auto all = found();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].vehicle, "unknown") << "its deployment is not YAML";
  EXPECT_EQ(all[1].vehicle, "unknown");
  EXPECT_EQ(all[1].run, "mine");
  EXPECT_THAT(object_of(all[1]), StartsWith("unknown/mine/mine_0-"));
}

TEST_F(RecordingsTest, WhatIsStillWrittenOrWasCutIsLeftOut) {
  SmallBag open(in("open"));
  open.drive(5);
  (void)open.writer().flush();
  put_text(in("cut.mcap"), "\x89MCAP0\r\n and then nothing");
  put_text(in("empty.mcap"), "");
  EXPECT_TRUE(found().empty());
  open.close();
  EXPECT_EQ(found().size(), 1U);
}

TEST_F(RecordingsTest, ACopyIsTheSame) {
  {
    SmallBag bag(in("one"));
    bag.drive(5);
  }
  std::filesystem::copy(in("one"), in("two"), std::filesystem::copy_options::recursive);
  const auto all = found();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].id, all[1].id);
}

TEST_F(RecordingsTest, NamesOfObjectsHaveNoStrangeLetters) {
  Recording recording;
  recording.path = "/x/bag ü_0.mcap";
  recording.id = "0123";
  recording.vehicle = "..";
  recording.run = "a/b c";
  EXPECT_EQ(object_of(recording), "_/a_b_c/bag____0-0123.mcap");
}

TEST_F(RecordingsTest, NamesAFolderThatIsNone) {
  try {
    (void)closed_recordings({in("absent")});
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("absent: is no folder"));
  }
}

}  // namespace
}  // namespace tocsin::archive
