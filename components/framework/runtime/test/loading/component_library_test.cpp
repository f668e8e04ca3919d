// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/component_library.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

std::string refusal_of(const std::string& name, const std::string& file) {
  try {
    (void)open_component(name, file);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ComponentLibrary, OneBuiltWithTheSameHeadersIsTaken) {
  EXPECT_THAT(open_component("link_lamp", README_LIBRARY).defaults(), HasSubstr("poor_below"));
}

// The library is made from test/other_layout.cpp, whose entry has another layout and no functions.
TEST(ComponentLibrary, OneBuiltWithOtherHeadersIsRefusedInOneLineThatNamesBothLayouts) {
  const std::string refusal = refusal_of("old_lamp", OTHER_LAYOUT_LIBRARY);
  EXPECT_THAT(refusal, HasSubstr("component 'old_lamp': " OTHER_LAYOUT_LIBRARY
                                 " was built with other headers: layout 2a, must be "));
  EXPECT_THAT(refusal, ::testing::Not(HasSubstr("\n")));
}

TEST(ComponentLibrary, ALibraryThatIsNoComponentIsRefused) {
  EXPECT_THAT(refusal_of("libc", "libc.so.6"), HasSubstr("component 'libc': "));
}

TEST(ComponentLibrary, AFileThatIsNotThereIsRefused) {
  EXPECT_THAT(refusal_of("lamp", "/nowhere/liblamp.so"), HasSubstr("/nowhere/liblamp.so"));
}

std::string refusal_of(const std::string& name) {
  try {
    (void)load_component(name);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ComponentLibrary, AComponentThatIsNotInstalledIsRefused) {
  EXPECT_THAT(refusal_of("no_such_component"),
              HasSubstr("component 'no_such_component': no installed package has one"));
}

/// A workspace that is sourced, with the components `odd_lamp` and `given_lamp`.
class SourcedWorkspace : public ::testing::Test {
 protected:
  SourcedWorkspace() {
    namespace fs = std::filesystem;
    folder_.write(std::string("ws/") + component_index + "/lamps",
                  "odd_lamp;lib/libodd_lamp.so\ngiven_lamp;lib/libodd_lamp.so\n");
    fs::create_directory(folder_.path("ws/lib"));
    fs::copy(README_LIBRARY, folder_.path("ws/lib/libodd_lamp.so"));
    setenv("AMENT_PREFIX_PATH", folder_.path("ws").c_str(), 1);
  }
  ~SourcedWorkspace() override { unsetenv("AMENT_PREFIX_PATH"); }
  const TemporaryFolder folder_;
};

TEST_F(SourcedWorkspace, ALibraryThatOthersMayReplaceIsRefusedUntilTheyMayNot) {
  std::filesystem::permissions(folder_.path("ws/lib"), std::filesystem::perms::all);
  EXPECT_THAT(refusal_of("odd_lamp"),
              HasSubstr("component 'odd_lamp': " + folder_.path("ws/lib") +
                        " may be written by everybody; what is loaded must belong to this user"));
  std::filesystem::permissions(folder_.path("ws/lib"), std::filesystem::perms::owner_all);
  EXPECT_EQ(refusal_of("odd_lamp"), "accepted");
}

TEST_F(SourcedWorkspace, ALibraryOfAnotherUserIsRefused) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give a file away";
  ASSERT_EQ(::chown(folder_.path("ws/lib/libodd_lamp.so").c_str(), 65'534, 65'534), 0);
  EXPECT_THAT(refusal_of("given_lamp"), HasSubstr("/libodd_lamp.so belongs to user 65534"));
}

// A container gets the name from a message of any peer.
TEST(ComponentLibrary, APathIsNotLoadedAsAName) {
  const TemporaryFolder folder;
  std::filesystem::copy(README_LIBRARY, folder.path("liblamp.so"));
  const std::string path = "../../../../../../../.." + folder.path() + "/lamp";
  for (const std::string& name : {path, folder.path("liblamp.so"), std::string("link_lamp\n"),
                                  std::string(), std::string("..")}) {
    EXPECT_THAT(refusal_of(name), HasSubstr("': is not a name (a lower-case letter, then such"));
  }
}

}  // namespace
}  // namespace tocsin
