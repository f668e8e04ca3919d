// SPDX-License-Identifier: Apache-2.0
#include "run_place.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::cli {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

class RunPlaceTest : public ::testing::Test {
 protected:
  [[nodiscard]] RunPlace place(const std::string& unnamed) const {
    return {unnamed, folder_.path("memory/")};
  }
  const TemporaryFolder folder_;
};

TEST_F(RunPlaceTest, TakesTheDiskAsLongAsItHasRoom) {
  const auto chosen = choose_run_folder("", place(folder_.path("runs/")));
  EXPECT_THAT(chosen.folder.path().string(), StartsWith(folder_.path("runs/")));
  EXPECT_EQ(chosen.warning, "");
  EXPECT_FALSE(std::filesystem::exists(folder_.path("memory")));
}

TEST_F(RunPlaceTest, TakesMemoryWhereNothingCanBeMade) {
  const auto chosen = choose_run_folder("", place("/proc/runs/"));
  EXPECT_THAT(chosen.folder.path().string(), StartsWith(folder_.path("memory/")));
  EXPECT_THAT(chosen.warning, StartsWith("NO DISK: /proc/runs"));
  EXPECT_THAT(chosen.warning, HasSubstr(folder_.path("memory/")));
}

TEST_F(RunPlaceTest, ANamedFolderIsThatOrNone) {
  EXPECT_THROW((void)choose_run_folder("/proc/named", place(folder_.path("runs/"))),
               EnvironmentError);
}

TEST_F(RunPlaceTest, WithoutMemoryItSaysWhatIsWrong) {
  EXPECT_THROW((void)choose_run_folder("", {"/proc/runs/", ""}), EnvironmentError);
}

TEST_F(RunPlaceTest, TheSparePlaceIsTheOneOfTheServiceManager) {
  ::unsetenv("RUNTIME_DIRECTORY");
  EXPECT_EQ(run_place().spare, "");
  ::setenv("RUNTIME_DIRECTORY", "/run/tocsin/vehicle:/run/other", 1);
  EXPECT_EQ(run_place().spare, "/run/tocsin/vehicle/");
  ::unsetenv("RUNTIME_DIRECTORY");
}

}  // namespace
}  // namespace tocsin::cli
