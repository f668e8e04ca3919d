// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/component_library.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
