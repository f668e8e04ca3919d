// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/component_library.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ComponentIndexTest : public ::testing::Test {
 protected:
  /// Installs a package with components to `prefix`; returns the prefix.
  std::string install(const std::string& prefix, const std::string& package,
                      const std::string& lines) {
    folder_.write(prefix + "/" + component_index + "/" + package, lines);
    return folder_.path(prefix);
  }
  /// The components that a program of the first workspace finds, as `name package`.
  std::vector<std::string> found(const PrefixPaths& environment,
                                 const std::string& program = "first/cli/bin/tocsin") {
    std::vector<std::string> words;
    for (const auto& one : components_in(package_prefixes(environment, folder_.path(program)))) {
      words.push_back(one.name + " " + one.library.lexically_relative(folder_.path()).string());
    }
    return words;
  }
  /// What colcon writes into an install folder with a folder for each package.
  void isolate(const std::string& workspace) {
    folder_.write(workspace + "/.colcon_install_layout", "isolated\n");
  }
  TemporaryFolder folder_;
};

TEST_F(ComponentIndexTest, AProgramFindsThePackagesBesideItsOwn) {
  isolate("first");
  install("first/lamps", "lamps", "lamp;lib/tocsin/liblamp.so\n");
  install("first/horns", "horns", "horn;lib/tocsin/libhorn.so\n");
  EXPECT_THAT(found({}), ElementsAre("horn first/horns/lib/tocsin/libhorn.so",
                                     "lamp first/lamps/lib/tocsin/liblamp.so"));
}

TEST_F(ComponentIndexTest, OneFolderForAllPackagesIsFoundAndItsNeighboursAreNot) {
  install("first", "lamps", "lamp;lib/liblamp.so\n");
  install("first", "horns", "horn;lib/libhorn.so\n");
  install("other", "bells", "bell;lib/libbell.so\n");
  EXPECT_THAT(found({}, "first/bin/tocsin"),
              ElementsAre("horn first/lib/libhorn.so", "lamp first/lib/liblamp.so"));
}

TEST_F(ComponentIndexTest, APackageMayHaveSeveralComponents) {
  install("first", "lamps", "red;lib/libred.so\ngreen;lib/libgreen.so\n");
  EXPECT_THAT(found({}, "first/bin/tocsin"),
              ElementsAre("green first/lib/libgreen.so", "red first/lib/libred.so"));
}

TEST_F(ComponentIndexTest, WorkspacesOfTheEnvironmentAreFoundByEachOfItsVariables) {
  isolate("second");
  install("second/a", "a", "a;lib/liba.so\n");
  const std::string b = install("third/b", "b", "b;lib/libb.so\n");
  const std::string c = install("third/c", "c", "c;lib/libc.so\n");
  EXPECT_THAT(
      found({folder_.path("second"), b, "/nowhere:" + c + ":"}),
      ElementsAre("a second/a/lib/liba.so", "b third/b/lib/libb.so", "c third/c/lib/libc.so"));
}

TEST_F(ComponentIndexTest, AWorkspaceThatWasSourcedLaterComesBefore) {
  isolate("first");
  install("first/lamps", "lamps", "lamp;lib/liblamp.so\n");
  install("overlay/mine", "mine", "lamp;lib/liblamp.so\n");
  EXPECT_THAT(found({folder_.path("overlay") + ":" + folder_.path("first"), "", ""}),
              ElementsAre("lamp overlay/mine/lib/liblamp.so"));
}

// The shell may have sourced another build than that of the program.
TEST_F(ComponentIndexTest, AProgramThatIsNotOfTheEnvironmentKeepsItsOwnComponents) {
  isolate("first");
  install("first/lamps", "lamps", "lamp;lib/liblamp.so\n");
  install("second/lamps", "lamps", "lamp;lib/liblamp.so\n");
  EXPECT_THAT(found({folder_.path("second"), "", ""}),
              ElementsAre("lamp first/lamps/lib/liblamp.so"));
}

TEST_F(ComponentIndexTest, NothingIsFoundWhereNothingIsInstalled) {
  EXPECT_THAT(found({}), IsEmpty());
}

TEST_F(ComponentIndexTest, ALineThatPointsOutOfThePackageOrIsNoneIsRefused) {
  for (const char* line :
       {"lamp", "lamp;", "Lamp;lib/liblamp.so", "../lamp;lib/liblamp.so", "lamp;/lib/libc.so.6",
        "lamp;lib/../../liblamp.so", "\x1b[2J;lib/a.so"}) {
    install("first", "lamps", std::string("horn;lib/libhorn.so\n") + line + "\n");
    try {
      (void)found({}, "first/bin/tocsin");
      ADD_FAILURE() << line;
    } catch (const ConfigError& error) {
      EXPECT_THAT(error.what(), HasSubstr("tocsin_components/lamps:2: '"));
      EXPECT_THAT(error.what(),
                  HasSubstr("' is not name;library, with the path of a library below"));
    }
  }
}

}  // namespace
}  // namespace tocsin
