// SPDX-License-Identifier: Apache-2.0
#include "command_line/bringup_options.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>

#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

BringupOptions parsed(const std::string& line) {
  CLI::App app;
  BringupOptions options;
  options.declare(app);
  app.parse(line);
  return options;
}

TEST(BringupOptions, TakeEverySettingInItsOrder) {
  const auto options =
      parsed("a.yaml --set x.a=1 --set x.a=2 --without uxv/payload --seed 7 --domain 9");
  EXPECT_THAT(options.overrides.set, testing::ElementsAre("x.a=1", "x.a=2"));
  EXPECT_THAT(options.overrides.without, testing::ElementsAre("uxv/payload"));
  EXPECT_EQ(options.overrides.seed, 7);
}

TEST(BringupOptions, TheDomainOfTheCommandLineReplacesTheFiles) {
  BringupOptions sut = parsed("a.yaml --domain 9");
  sut.locate();
  EXPECT_EQ(sut.overrides.domain, 9);
}

TEST(BringupOptions, CanBeGivenOnToAnotherCommand) {
  const std::string line =
      "a.yaml --seed 7 --set x.a=1 --set x.b=2 --without uxv/payload --channel c.yaml --security k "
      "--qos q.yaml --traffic t.yaml --domain 9";
  std::string joined;
  for (const std::string& word : parsed(line).arguments()) {
    joined += (joined.empty() ? "" : " ") + word;
  }
  EXPECT_EQ(joined, line);
}

TEST(BringupOptions, AFileThatIsThereIsTakenAsItIs) {
  const TemporaryFolder folder;
  BringupOptions sut = parsed(folder.write("a.yaml", ""));
  sut.locate();
  EXPECT_EQ(sut.file, folder.path("a.yaml"));
}

}  // namespace
}  // namespace tocsin
