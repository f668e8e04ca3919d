// SPDX-License-Identifier: Apache-2.0
#include "deployment/run_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <list>
#include <set>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::deployment {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Property;
using ::testing::Throws;

class RunFolderTest : public ::testing::Test {
 protected:
  const TemporaryFolder folder_;
};

TEST_F(RunFolderTest, RefusesAUsedOneAndLeavesItAsItIs) {
  folder_.write("run/processes.json", "{\"uxv/drive\": 7}");
  EXPECT_THAT(
      [&] { RunFolder{folder_.path("run")}; },
      Throws<ConfigError>(Property(
          &ConfigError::what, HasSubstr("--run-dir " + folder_.path("run") + ": is not empty"))));
  EXPECT_EQ(folder_.read("run/processes.json"), "{\"uxv/drive\": 7}");
}

TEST_F(RunFolderTest, RefusesOneThatOthersMayWriteTo) {
  fs::create_directory(folder_.path("run"));
  fs::permissions(folder_.path("run"), fs::perms::all);
  EXPECT_THAT([&] { RunFolder{folder_.path("run")}; },
              Throws<ConfigError>(
                  Property(&ConfigError::what, HasSubstr("--run-dir " + folder_.path("run") +
                                                         ": may be written by everybody"))));
}

TEST_F(RunFolderTest, RefusesOneThatAnotherRunHasJustTaken) {
  const RunFolder first(folder_.path("run"));
  EXPECT_THAT([&] { RunFolder{folder_.path("run")}; },
              Throws<ConfigError>(Property(&ConfigError::what, HasSubstr("another run"))));
}

TEST_F(RunFolderTest, GivesEachRunOfOneSecondAFolderOfItsOwn) {
  std::list<RunFolder> runs;
  std::set<std::string> names;
  for (int i = 0; i < 5; ++i) {
    runs.emplace_back("", folder_.path("runs/"));
    names.insert(runs.back().path());
  }
  EXPECT_EQ(names.size(), 5U);
  EXPECT_THAT(*names.begin(), HasSubstr(folder_.path("runs/2")));
}

TEST_F(RunFolderTest, SaysWhyItCannotBeMade) {
  folder_.write("file", "");
  EXPECT_THAT([&] { RunFolder{folder_.path("file/run")}; },
              Throws<EnvironmentError>(
                  Property(&EnvironmentError::what, HasSubstr("cannot be made: Not a directory"))));
}

}  // namespace
}  // namespace tocsin::deployment
