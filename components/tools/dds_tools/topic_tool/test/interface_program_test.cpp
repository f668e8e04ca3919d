// SPDX-License-Identifier: Apache-2.0
// `tocsin interface` as a user runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "command_line/run_to_end.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::topic_tool {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

Ended interface(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), INTERFACE_PROGRAM);
  return run_to_end(arguments);
}

TEST(InterfaceProgram, ListsAndShowsInterfaces) {
  const Ended all = interface({"list"});
  EXPECT_EQ(all.code, 0);
  EXPECT_THAT(all.output, StartsWith("Messages:\n"));
  EXPECT_THAT(all.output, HasSubstr("\nServices:\n"));
  EXPECT_THAT(all.output, HasSubstr("\n    nav2_msgs/action/NavigateToPose\n"));
  EXPECT_THAT(interface({"package", "std_srvs"}).output,
              "std_srvs/srv/Empty\nstd_srvs/srv/SetBool\nstd_srvs/srv/Trigger\n");
  EXPECT_THAT(interface({"packages"}).output, HasSubstr("std_srvs\n"));
  EXPECT_EQ(interface({"show", "std_srvs/srv/SetBool"}).output,
            "bool data\n---\nbool success\nstring message\n");
}

TEST(InterfaceProgram, ShowsAMessageToCopy) {
  EXPECT_EQ(interface({"proto", "std_srvs/srv/SetBool"}).output, "\"data: false\n\"\n");
  EXPECT_EQ(interface({"proto", "--no-quotes", "std_srvs/srv/SetBool"}).output, "data: false\n\n");
}

TEST(InterfaceProgram, ExportsAPackageOnce) {
  const TemporaryFolder folder;
  const Ended done = interface({"export", "std_srvs", folder.path()});
  EXPECT_EQ(done.code, 0) << done.output;
  EXPECT_TRUE(std::filesystem::exists(folder.path("std_srvs/package.xml")));
  EXPECT_TRUE(std::filesystem::exists(folder.path("std_srvs/srv/SetBool.srv")));
  const Ended again = interface({"export", "std_srvs", folder.path()});
  EXPECT_EQ(again.code, 2);
  EXPECT_THAT(again.output, HasSubstr("std_srvs is there already"));
  EXPECT_THAT(interface({"export", "no_msgs"}).output,
              HasSubstr("the package 'no_msgs' is not known here"));
}

TEST(InterfaceProgram, SaysInOneLineWhatIsNotKnown) {
  const Ended type = interface({"show", "no_msgs/msg/Thing"});
  EXPECT_EQ(type.code, 2);
  EXPECT_THAT(type.output, HasSubstr("the interface 'no_msgs/msg/Thing' is not known here"));
  const Ended package = interface({"package", "no_msgs"});
  EXPECT_EQ(package.code, 2);
  EXPECT_THAT(package.output, HasSubstr("the package 'no_msgs' is not known here"));
}

}  // namespace
}  // namespace tocsin::topic_tool
