// SPDX-License-Identifier: Apache-2.0
#include "foundation/yaml_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

/// `depth` lists in each other.
std::string nested(int depth) { return repeated("[", depth) + repeated("]", depth); }

/// A list of `nodes` nodes, itself one of them.
std::string list_of(int nodes) { return "[" + repeated("a,", nodes - 2) + "a]"; }

template <class Body>
std::string error_from(Body body) {
  try {
    (void)body();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

/// Of a file `a.yaml` with this text.
std::string error_of(const std::string& yaml) {
  static const TemporaryFolder folder;
  const std::string path = folder.write("a.yaml", yaml);
  const std::string error = error_from([&] { return read_yaml_file(path); });
  return error.rfind(path, 0) == 0 ? "a.yaml" + error.substr(path.size()) : error;
}

std::string error_of_file(const std::string& path) {
  return error_from([&] { return read_yaml_file(path); });
}

TEST(YamlText, IsReadWithItsLines) {
  const YAML::Node node = read_yaml_text("a: 1\nb: [x, y]", "a.yaml");
  EXPECT_EQ(node["b"][1].Scalar(), "y");
  EXPECT_EQ(yaml_place("a.yaml", node["b"]), " (a.yaml:2)");
  EXPECT_TRUE(read_yaml_text("", "a.yaml").IsNull());
}

TEST(YamlText, MayUseAnAliasForWhatStandsBeforeIt) {
  const YAML::Node node = read_yaml_text("a: &x [1, 2]\nb: *x\nc: *x", "a.yaml");
  EXPECT_EQ(node["c"][1].as<int>(), 2);
}

TEST(YamlText, RefusesAnAliasWithinWhatItStandsFor) {
  const std::string expected = "a.yaml:2: an alias within what it stands for, without end";
  EXPECT_EQ(error_of("a: 1\nstop_only: &x [*x]"), expected);
  EXPECT_EQ(error_of("a: 1\nb: &x {c: {d: *x}}"), expected);
  EXPECT_THAT(error_of("&x [&y [*x, *y]]"), HasSubstr("without end"));
}

TEST(YamlText, RefusesAnAliasOfNothing) {
  EXPECT_THAT(error_of("a: 1\nb: *x"), StartsWith("a.yaml:2: not valid YAML: "));
}

TEST(YamlText, RefusesTheBillionLaughs) {
  std::string laughs = "a0: &a0 [" + repeated("ha,", 10) + "]\n";
  for (int i = 1; i < 9; ++i) {
    const std::string before = std::to_string(i - 1);
    const std::string here = std::to_string(i);
    laughs += "a" + here + ": &a" + here + " [" + repeated("*a" + before + ",", 10) + "]\n";
  }
  EXPECT_EQ(error_of(laughs), "a.yaml:5: more than 100000 nodes, with what aliases stand for");
}

TEST(YamlText, RefusesMoreThanTheMostNodes) {
  EXPECT_EQ(error_of(list_of(100'000)), "no error");
  EXPECT_THAT(error_of(list_of(100'001)), HasSubstr("more than 100000 nodes"));
}

TEST(YamlText, RefusesWhatIsDeeperThanTheLimit) {
  EXPECT_EQ(error_of(nested(32)), "no error");
  EXPECT_EQ(error_of("\n" + nested(33)), "a.yaml:2: more than 32 lists and maps in each other");
  EXPECT_EQ(error_of("[&x " + nested(30) + ", [*x]]"), "no error");
  EXPECT_THAT(error_of("[&x " + nested(31) + ", [*x]]"), HasSubstr("more than 32 lists"));
}

TEST(YamlText, RefusesWhatIsLongerThanTheLimit) {
  const std::string longest(std::size_t{1} << 19U, '#');
  EXPECT_EQ(error_of(longest), "no error");
  EXPECT_EQ(error_of(longest + "#"), "a.yaml: has more than 524288 bytes");
}

TEST(YamlText, RefusesAKeyThatIsGivenTwice) {
  EXPECT_EQ(error_of("a: 1\nb: 2\na: 3"), "a.yaml:3: key 'a' is given twice, first in line 1");
  EXPECT_EQ(error_of("a: {a: 1}\nb: {a: 1}"), "no error");
}

TEST(YamlText, RefusesKeysThatAreNoText) {
  EXPECT_THAT(error_of("[1]: 2"), HasSubstr("a key that is a list or map"));
  EXPECT_THAT(error_of("{{a: 1}: 2}"), HasSubstr("a key that is a list or map"));
  EXPECT_THAT(error_of("a: &x b\n*x : 1"), HasSubstr("a key that is an alias"));
  EXPECT_THAT(error_of("~: 2"), HasSubstr("a key that is empty"));
}

TEST(YamlText, RefusesASecondDocument) {
  EXPECT_EQ(error_of("a: 1\n---\nb: 2"), "a.yaml:2: a second YAML document; a file holds one");
  EXPECT_EQ(error_of("---\na: 1\n..."), "no error");
}

TEST(YamlText, NamesTheLineOfWhatIsNotYaml) {
  EXPECT_THAT(error_of("a: 1\nb: ]"), StartsWith("a.yaml:2: not valid YAML: "));
  for (const char* open : {"{", "[", "{a: [", "- [a"}) {
    EXPECT_THAT(error_of(open), StartsWith("a.yaml:1: not valid YAML: ")) << open;
  }
}

TEST(YamlText, ATabInTheIndentationIsCalledATab) {
  const std::string tab = ": not valid YAML: a tab in the indentation; YAML is indented by spaces";
  EXPECT_EQ(error_of("a:\n\tb: 1"), "a.yaml:2" + tab);
  EXPECT_EQ(error_of("a:\n  b: 1\n\tc: 2"), "a.yaml:3" + tab);
  EXPECT_EQ(error_of("\ta: 1"), "a.yaml:1" + tab);
  EXPECT_EQ(error_of("a: [1,\n\t2]"), "no error") << "allowed within brackets";
  EXPECT_THAT(error_of("a: \t]"), Not(HasSubstr("a tab"))) << "behind the key";
}

TEST(YamlFile, IsReadFromADisk) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_yaml_file(folder.write("a.yaml", "a: 1"))["a"].as<int>(), 1);
}

TEST(YamlFile, IsNamedInErrors) {
  const TemporaryFolder folder;
  const std::string path = folder.write("a.yaml", "a: &x [*x]");
  EXPECT_THAT(error_of_file(path), StartsWith(path + ":1: an alias"));
  EXPECT_EQ(error_of_file("/nowhere"), "/nowhere: cannot be read: No such file or directory");
  EXPECT_EQ(error_of_file("/tmp"), "/tmp: cannot be read: Is a directory");
  EXPECT_EQ(error_of_file("/dev/null"), "/dev/null: is empty");
  EXPECT_EQ(error_of_file("/dev/zero"), "/dev/zero: has more than 524288 bytes");
}

}  // namespace
}  // namespace tocsin
