// SPDX-License-Identifier: Apache-2.0
#include "foundation/yaml_sources.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <filesystem>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::StartsWith;

class YamlSourcesTest : public ::testing::Test {
 protected:
  [[nodiscard]] YAML::Node read(const std::string& name, const std::string& text) {
    return sut_.read(folder_.write(name, text));
  }
  [[nodiscard]] std::string error_of(const std::string& text) {
    try {
      (void)read("bad.yaml", text);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path(name); }

  const TemporaryFolder folder_;
  YamlSources sut_;
};

TEST_F(YamlSourcesTest, KnowsFileAndLineOfEveryNode) {
  const YAML::Node a = read("a.yaml", "x: 1\ny:\n  z: 2\n");
  const YAML::Node b = read("b.yaml", "\n\nx: 3");
  const YAML::Node c = read("c.yaml", "x: 4");
  EXPECT_EQ(sut_.place(a["x"]), path("a.yaml") + ":1");
  EXPECT_EQ(sut_.place(a["y"]["z"]), path("a.yaml") + ":3");
  EXPECT_EQ(sut_.place(b["x"]), path("b.yaml") + ":3");
  EXPECT_EQ(sut_.place(c["x"]), path("c.yaml") + ":1");
  EXPECT_EQ(sut_.file(b["x"]), path("b.yaml"));
  EXPECT_THAT(sut_.files(), ElementsAre(path("a.yaml"), path("b.yaml"), path("c.yaml")));
}

TEST_F(YamlSourcesTest, AnEmptyValueAtTheEndOfAFileIsOfThatFile) {
  const YAML::Node a = read("a.yaml", "x:");
  (void)read("b.yaml", "y: 1");
  EXPECT_TRUE(a["x"].IsNull());
  EXPECT_EQ(sut_.file(a["x"]), path("a.yaml"));
}

TEST_F(YamlSourcesTest, ANodeKeepsItsPlaceWhenItsValueIsReplacedInPlace) {
  (void)read("a.yaml", "x: 1");
  const YAML::Node b = read("b.yaml", "\nx: 3");
  YAML::Node value = b["x"];
  value = std::string("else");
  EXPECT_EQ(sut_.place(b["x"]), path("b.yaml") + ":2");
}

TEST_F(YamlSourcesTest, ATextThatIsNoFileHasANameAndNoLines) {
  (void)read("a.yaml", "x: 1");
  const YAML::Node setting = sut_.parse("[1, 2]", "--set a.b=[1, 2]");
  EXPECT_EQ(sut_.place(setting), "--set a.b=[1, 2]");
  EXPECT_THAT(sut_.files(), ElementsAre(path("a.yaml")));
}

TEST_F(YamlSourcesTest, AnErrorHasTheLineWithinItsFile) {
  (void)read("a.yaml", "x: 1\ny: 2\n");
  EXPECT_THAT(error_of("x: 1\ny: [\n"), StartsWith(path("bad.yaml") + ":3: not valid YAML: "));
  try {
    (void)sut_.parse("[", "--set a.b=[");
    FAIL() << "no error";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), StartsWith("--set a.b=[: not valid YAML: "));
  }
}

TEST_F(YamlSourcesTest, ReadsAFileWithAByteOrderMark) {
  (void)read("a.yaml", "x: 1");
  EXPECT_EQ(read("b.yaml", "\xEF\xBB\xBFx: 2")["x"].as<int>(), 2);
}

TEST_F(YamlSourcesTest, RefusesAFileThatCannotBeRead) {
  EXPECT_THROW((void)sut_.read("/nowhere/a.yaml"), ConfigError);
}

TEST_F(YamlSourcesTest, PathsAreRelativeToTheFileThatNamesThem) {
  const YAML::Node a = read("a.yaml", "x: ../m.pgm");
  const YAML::Node b = read("deep/b.yaml", "x: ../m.pgm");
  const std::filesystem::path folder = path("");
  EXPECT_EQ(sut_.path(a["x"], "m.pgm"), path("m.pgm"));
  EXPECT_EQ(sut_.path(b["x"], b["x"].Scalar()), path("m.pgm"));
  EXPECT_EQ(sut_.path(b["x"], "/m.pgm"), "/m.pgm");
}

TEST(YamlSources, NodesThatWereReadElsewhereAreOfTheOneFile) {
  const YamlSources sut("robot.yaml");
  const YAML::Node node = YAML::Load("a: 1\nb: 2");
  EXPECT_EQ(sut.place(node["b"]), "robot.yaml:2");
  EXPECT_EQ(sut.place(YAML::Node(3)), "robot.yaml");
}

TEST(YamlSources, WithoutFilesHasNoPlace) {
  EXPECT_EQ(YamlSources().place(YAML::Load("a: 1")), "");
}

}  // namespace
}  // namespace tocsin
