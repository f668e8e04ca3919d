// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/idl_libraries.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;

TEST(IdlLibraries, AreThoseOfPackagesWithIdlFiles) {
  const TemporaryFolder folder;
  for (const char* file :
       {"one/share/b_msgs/idl/b.idl", "one/lib/libb_msgs.so", "one/share/a_msgs/idl/a.idl",
        "one/lib/liba_msgs.so", "one/share/robot/package.xml", "one/lib/librobot.so",
        "two/share/c_msgs/idl/c.idl"}) {
    (void)folder.write(file, "");
  }
  EXPECT_THAT(
      idl_libraries_in(
          {folder.path("one"), folder.path("two"), folder.path("one"), folder.path("absent")}),
      ElementsAre(folder.path("one/lib/liba_msgs.so"), folder.path("one/lib/libb_msgs.so")));
}

TEST(IdlLibraries, ThatOthersMayReplaceAreLeftOut) {
  const TemporaryFolder folder;
  for (const char* file : {"one/share/a_msgs/idl/a.idl", "one/lib/liba_msgs.so",
                           "one/share/b_msgs/idl/b.idl", "one/lib/libb_msgs.so"}) {
    (void)folder.write(file, "");
  }
  std::filesystem::permissions(folder.path("one/lib/liba_msgs.so"), std::filesystem::perms::all);
  EXPECT_THAT(idl_libraries_in({folder.path("one")}),
              ElementsAre(folder.path("one/lib/libb_msgs.so")));
}

}  // namespace
}  // namespace tocsin
