// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop_input/stop_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

class StopFileTest : public ::testing::Test {
 protected:
  [[nodiscard]] StopMemory load() const { return StopFile(path_).load(); }
  const TemporaryFolder folder_;
  const std::string path_ = folder_.path("driver.stop");
  StopFile sut_{path_};
};

TEST_F(StopFileTest, LoadsWhatWasSaved) {
  for (int bits = 0; bits < 16; ++bits) {
    const StopMemory memory{{(bits & 1) != 0, (bits & 2) != 0}, {(bits & 4) != 0, (bits & 8) != 0}};
    ASSERT_TRUE(sut_.save(memory));
    const StopMemory got = load();
    EXPECT_EQ(got.latch.station, memory.latch.station);
    EXPECT_EQ(got.latch.others, memory.latch.others);
    EXPECT_EQ(got.link.stands, memory.link.stands);
    EXPECT_EQ(got.link.expects, memory.link.expects);
  }
}

TEST_F(StopFileTest, NothingStandsWithoutAFile) {
  EXPECT_FALSE(load().latch.station);
  EXPECT_FALSE(load().link.stands);
}

TEST_F(StopFileTest, AFileOfAnotherLaunchOrADamagedOneKeepsNothing) {
  StateFile file(path_);
  ASSERT_TRUE(file.save("1 1 1 1 1"));
  EXPECT_FALSE(load().latch.station);
  ASSERT_TRUE(file.save(std::to_string(::getppid()) + " 1 1"));
  EXPECT_FALSE(load().latch.station);
}

TEST_F(StopFileTest, TellsOnceThatItCannotBeWrittenAndTriesAgain) {
  StopFile nowhere(folder_.path("absent/driver.stop"));
  EXPECT_FALSE(nowhere.save({{true, false}, {}}));
  EXPECT_TRUE(nowhere.save({{true, false}, {}}));
  std::filesystem::create_directory(folder_.path("absent"));
  EXPECT_TRUE(nowhere.save({{true, false}, {}}));
  EXPECT_TRUE(StopFile(folder_.path("absent/driver.stop")).load().latch.station);
}

TEST_F(StopFileTest, AnEmptyPathKeepsNothing) {
  EXPECT_TRUE(StopFile("").save({{true, true}, {true, true}}));
  EXPECT_FALSE(StopFile("").load().link.stands);
}

}  // namespace
}  // namespace tocsin
