// SPDX-License-Identifier: Apache-2.0
#include "fast_dds/shared_memory_leftovers.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace tocsin {
namespace {

class SharedMemoryLeftovers : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = ::testing::TempDir() + "/leftovers_" + std::to_string(getpid());
    std::filesystem::create_directory(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void make(const std::string& name) const { std::ofstream(folder_ + "/" + name) << "x"; }
  [[nodiscard]] bool exists(const std::string& name) const {
    return std::filesystem::exists(folder_ + "/" + name);
  }
  std::string folder_;
};

TEST_F(SharedMemoryLeftovers, OfADeadProcessAreRemoved) {
  for (const char* name : {"fastrtps_0a", "fastrtps_0a_el", "fastrtps_port7", "fastrtps_port7_el",
                           "sem.fastrtps_port7_mutex"}) {
    make(name);
  }
  EXPECT_EQ(remove_shared_memory_leftovers(folder_), 2);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(SharedMemoryLeftovers, OfALivingProcessAreLeftAlone) {
  make("fastrtps_0a");
  make("fastrtps_0a_el");
  const int held = open((folder_ + "/fastrtps_0a_el").c_str(), O_RDWR);
  ASSERT_EQ(flock(held, LOCK_EX), 0);
  EXPECT_EQ(remove_shared_memory_leftovers(folder_), 0);
  EXPECT_TRUE(exists("fastrtps_0a"));
  close(held);
  EXPECT_EQ(remove_shared_memory_leftovers(folder_), 1);
  EXPECT_FALSE(exists("fastrtps_0a"));
}

TEST_F(SharedMemoryLeftovers, OfOtherProgramsAreLeftAlone) {
  make("other_el");
  make("fastrtps_el");
  make("fastrtps_0a");
  EXPECT_EQ(remove_shared_memory_leftovers(folder_), 0);
  EXPECT_TRUE(exists("other_el"));
  EXPECT_TRUE(exists("fastrtps_0a"));
}

TEST_F(SharedMemoryLeftovers, AFolderThatIsNotThereHasNone) {
  EXPECT_EQ(remove_shared_memory_leftovers(folder_ + "/nowhere"), 0);
}

}  // namespace
}  // namespace tocsin
