// SPDX-License-Identifier: Apache-2.0
#include "full_disk.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <optional>
#include <sstream>

#include "foundation/state_file.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::simulation {
namespace {

class FullDiskTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::string text_of(const std::string& path) const {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }
  const TemporaryFolder temporary_;
  const std::string path_ = temporary_.path() + "/rows.csv";
};

TEST_F(FullDiskTest, AppendsFailAndGoOnWhenThereIsRoom) {
  std::ofstream file(path_, std::ios::app);
  std::ofstream idle(path_, std::ios::app);
  file << "before\n" << std::flush;
  {
    const FullDisk sut(temporary_.path());
    EXPECT_FALSE(file << "lost\n" << std::flush);
    EXPECT_EQ(errno, ENOSPC);
  }
  idle << "after\n" << std::flush;  // its descriptor is the file again
  EXPECT_EQ(text_of(path_), "before\nafter\n");
}

TEST_F(FullDiskTest, TheNumberOfAFileThatWasClosedMeanwhileStaysWithItsNewOwner) {
  const TemporaryFolder elsewhere;
  std::optional<std::ofstream> file(std::in_place, path_, std::ios::app);
  std::optional<FullDisk> disk(std::in_place, temporary_.path());
  file.reset();
  std::ofstream other(elsewhere.path() + "/rows.csv", std::ios::app);  // takes its number
  disk.reset();
  EXPECT_TRUE(other << "row\n" << std::flush);
  EXPECT_EQ(text_of(elsewhere.path() + "/rows.csv"), "row\n");
  EXPECT_EQ(text_of(path_), "");
}

TEST_F(FullDiskTest, StateFilesAndFilesElsewhereGoOn) {
  StateFile state(temporary_.path() + "/pose");
  ASSERT_TRUE(state.save("1"));
  const TemporaryFolder elsewhere;
  std::ofstream file(elsewhere.path() + "/rows.csv", std::ios::app);
  const FullDisk sut(temporary_.path());
  EXPECT_TRUE(state.save("2"));
  EXPECT_EQ(state.load(), "2");
  EXPECT_TRUE(file << "row\n" << std::flush);
}

}  // namespace
}  // namespace tocsin::simulation
