// SPDX-License-Identifier: Apache-2.0
#include "command_line/programs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Programs, LooksBesideTheProgramThenInThePath) {
  EXPECT_THAT(program_folders("/opt/build/tocsin", "/usr/bin::/bin"),
              ElementsAre("/opt/build", "/usr/bin", "/bin"));
}

TEST(Programs, LooksInAllBinFoldersOfAnIsolatedInstall) {
  const TemporaryFolder folder;
  folder.write("install/a/bin/x", "");
  folder.write("install/b/bin/x", "");
  folder.write("install/c/lib/x", "");
  EXPECT_THAT(program_folders(folder.path("install/b/bin/tocsin"), ""),
              ElementsAre(folder.path("install/b/bin"), folder.path("install/a/bin"),
                          folder.path("install/b/bin")));
}

TEST(Programs, FindsTheFirstExecutableFile) {
  const TemporaryFolder folder;
  folder.write("one/tool", "not executable");
  folder.write_program("two/tool", "");
  folder.write_program("three/tool", "");
  const Folders folders{folder.path("one"), folder.path("two"), folder.path("three")};
  EXPECT_EQ(find_program("tool", folders), folder.path("two/tool"));
  EXPECT_EQ(find_program("saw", folders), std::nullopt);
}

TEST(Programs, TakesANameWithASlashAsItIs) {
  EXPECT_EQ(find_program("/bin/sh", {}), "/bin/sh");
  EXPECT_EQ(find_program("/bin/no_such_program", {"/bin"}), std::nullopt);
}

TEST(Programs, ListsEachVerbOnceInOrder) {
  const TemporaryFolder folder;
  folder.write_program("one/tocsin-launch", "");
  folder.write_program("two/tocsin-launch", "");
  folder.write_program("two/tocsin-check", "");
  folder.write("two/tocsin-text", "not executable");
  EXPECT_THAT(find_verbs({folder.path("one"), folder.path("two"), folder.path("absent")}),
              ElementsAre("check", "launch"));
}

TEST(Programs, FindsTheShareOfAnIsolatedInstall) {
  const TemporaryFolder folder;
  folder.write("bringup/share/tocsin/config/qos.yaml", "");
  EXPECT_EQ(share_folder(folder.path("tocsin_cli/bin/tocsin")),
            folder.path("bringup/share/tocsin"));
}

TEST(Programs, FindsTheShareOfAMergedInstall) {
  const TemporaryFolder folder;
  folder.write("usr/share/tocsin/config/qos.yaml", "");
  EXPECT_EQ(share_folder(folder.path("usr/bin/tocsin")), folder.path("usr/share/tocsin"));
  EXPECT_EQ(share_folder("/absent/bin/tocsin"), "/absent/share/tocsin");
}

}  // namespace
}  // namespace tocsin
