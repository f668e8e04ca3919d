// SPDX-License-Identifier: Apache-2.0
#include "foundation/yaml_extends.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <array>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin {
namespace {

using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

ListMerge by_key(const YamlPath& path) {
  if (path.back() == "files") return ListMerge::append;
  return path.back() == "parts" ? ListMerge::by_name : ListMerge::replace;
}

/// The node in flow style, what is shared as often as it is there.
std::string flow(const YAML::Node& node) {
  if (node.IsScalar()) return node.Scalar();
  if (node.IsNull()) return "~";
  std::string text;
  for (const auto& entry : node) {
    text += text.empty() ? "" : ", ";
    text += node.IsMap() ? entry.first.Scalar() + ": " + flow(entry.second) : flow(entry);
  }
  return node.IsMap() ? "{" + text + "}" : "[" + text + "]";
}

class YamlExtendsTest : public ::testing::Test {
 protected:
  /// What `text` makes of the files that it extends.
  [[nodiscard]] std::string merged(const std::string& text) { return flow(read(text)); }
  [[nodiscard]] YAML::Node read(const std::string& text) {
    return read_extended(write("own.yaml", text), rules_, sources_);
  }
  [[nodiscard]] std::string error_of(const std::string& text) {
    try {
      (void)read(text);
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "no error";
  }
  std::string write(const std::string& name, const std::string& text) const {
    return folder_.write(name, text);
  }
  [[nodiscard]] std::string path(const std::string& name) const { return folder_.path(name); }

  const TemporaryFolder folder_;
  ExtendRules rules_{folder_.path("shipped"), by_key, nullptr};
  YamlSources sources_;
};

TEST_F(YamlExtendsTest, AFileThatExtendsNothingIsAsItIs) {
  EXPECT_EQ(merged("a: {b: [1, 2]}"), "{a: {b: [1, 2]}}");
  EXPECT_EQ(merged("[1, 2]"), "[1, 2]");
}

TEST_F(YamlExtendsTest, IsMergedIntoItsBaseKeyByKeyAndNameByName) {
  for (const auto& [base, own, result] : std::vector<std::array<const char*, 3>>{
           {"a: 1\nb: {c: 2, d: 3}\ne: 4", "f: 5\nb: {d: 6, g: 7}",
            "{a: 1, b: {c: 2, d: 6, g: 7}, e: 4, f: 5}"},
           {"a: [1, 2]", "a: [3]", "{a: [3]}"},
           {"files: [1, 2]", "files: [2, 3]", "{files: [1, 2, 2, 3]}"},
           {"parts: [a, {name: b, x: 1, y: 2}, {component: c, x: 3}]",
            "parts: [{name: b, y: 4}, d, {component: a, z: 5}, c]",
            "{parts: [{component: a, z: 5}, {name: b, x: 1, y: 4}, {component: c, x: 3}, d]}"},
           {"a: {b: 1}\nc: [1]\nd: 2", "a: 3\nc: {e: 4}\nd: [5]", "{a: 3, c: {e: 4}, d: [5]}"},
           {"a: 1\nb: {c: 2, d: 3}\nparts: [e, {name: f, x: 1}]",
            "a: ~\nb: {c: null}\nparts:\n  - f: ~", "{b: {d: 3}, parts: [e]}"},
           {"a: &x {c: 1}\nb: *x", "a: {c: 2}", "{a: {c: 2}, b: {c: 1}}"},
           {"a: {c: 1}\nb: {d: 2}", "a: &x {e: 3}\nb: *x", "{a: {c: 1, e: 3}, b: {d: 2, e: 3}}"}}) {
    write("base.yaml", base);
    EXPECT_EQ(merged(std::string("extends: base.yaml\n") + own), result);
  }
}

TEST_F(YamlExtendsTest, TellsWhatWasTakenAway) {
  write("base.yaml", "a: {b: 1, c: {d: 2}}\nparts: [e, {name: f, x: 1}]");
  std::vector<YamlRemoval> removed;
  (void)read_extended(write("own.yaml", "extends: base.yaml\na: {c: ~}\nparts:\n  - f: ~\n"),
                      rules_, sources_, &removed);
  ASSERT_EQ(removed.size(), 2U);
  EXPECT_EQ(removed[0].path, (YamlPath{"a", "c"}));
  EXPECT_EQ(flow(*removed[0].value), "{d: 2}");
  EXPECT_EQ(removed[1].path, (YamlPath{"parts", "f"}));
}

TEST_F(YamlExtendsTest, RefusesToTakeAwayWhatIsNotThere) {
  write("base.yaml", "a: 1\nb: {c: 2, d: 3}\nparts: [e]");
  EXPECT_EQ(error_of("extends: base.yaml\nb: {x: ~}"),
            "b.x: there is nothing to remove; the base has [c, d] (" + path("own.yaml") + ":2)");
  EXPECT_THAT(error_of("extends: base.yaml\nparts:\n  - f: ~\n"),
              StartsWith("parts.f: there is nothing to remove; the base has [e] ("));
}

TEST_F(YamlExtendsTest, ASectionWhoseLinesAreCommentedOutRemovesNothing) {
  write("base.yaml", "a: {b: 1}");
  EXPECT_EQ(error_of("extends: base.yaml\na:\n#  b: 2\n"),
            "a: is empty; 'a: ~' takes away what the base has (" + path("own.yaml") + ":2)");
  EXPECT_THAT(error_of("extends: base.yaml\na:"), StartsWith("a: is empty;"));
  EXPECT_EQ(merged("extends: base.yaml\nc:\n"), "{a: {b: 1}, c: ~}");
}

TEST_F(YamlExtendsTest, OfAListOfFilesTheLaterOnesWin) {
  write("one.yaml", "a: 1\nb: 1\nc: 1");
  write("two.yaml", "b: 2\nc: 2");
  EXPECT_EQ(merged("extends: [one.yaml, two.yaml]\nc: 3"), "{a: 1, b: 2, c: 3}");
}

TEST_F(YamlExtendsTest, ABaseMayExtendAnother) {
  write("one.yaml", "a: 1\nb: 1\nc: 1");
  write("deep/two.yaml", "extends: ../one.yaml\nb: 2\nc: 2");
  EXPECT_EQ(merged("extends: deep/two.yaml\nc: 3"), "{a: 1, b: 2, c: 3}");
}

TEST_F(YamlExtendsTest, TwoBasesMayExtendTheSameFile) {
  write("one.yaml", "a: 1");
  write("two.yaml", "extends: one.yaml\nb: 2");
  write("three.yaml", "extends: one.yaml\nc: 3");
  EXPECT_EQ(merged("extends: [two.yaml, three.yaml]"), "{a: 1, b: 2, c: 3}");
}

TEST_F(YamlExtendsTest, EachNodeKnowsItsFile) {
  write("base.yaml", "\n\na: {b: 1, c: 2}\nd: 3");
  const YAML::Node node = read("extends: base.yaml\na:\n  c: 4\n");
  EXPECT_EQ(sources_.place(node["a"]["b"]), path("base.yaml") + ":3");
  EXPECT_EQ(sources_.place(node["a"]["c"]), path("own.yaml") + ":3");
  EXPECT_EQ(sources_.place(node["d"]), path("base.yaml") + ":4");
  for (const auto& entry : node["a"]) {
    EXPECT_THAT(sources_.place(entry.first),
                entry.first.Scalar() == "b" ? EndsWith("base.yaml:3") : EndsWith("own.yaml:3"));
  }
}

TEST_F(YamlExtendsTest, ABareNameThatIsNotThereIsAShippedOne) {
  write("shipped/base.yaml", "a: shipped");
  EXPECT_EQ(merged("extends: base.yaml"), "{a: shipped}");
  write("base.yaml", "a: beside");
  EXPECT_EQ(merged("extends: base.yaml"), "{a: beside}");
}

TEST_F(YamlExtendsTest, AFileMayExtendTheShippedOneOfItsName) {
  write("shipped/own.yaml", "a: 1\nb: 2");
  EXPECT_EQ(merged("extends: own.yaml\nb: 3"), "{a: 1, b: 3}");
}

TEST_F(YamlExtendsTest, RefusesAFileThatIsNotThere) {
  EXPECT_EQ(error_of("a: 1\nextends: base.yaml"), "extends: no file " + path("base.yaml") +
                                                      ", nor is " + path("shipped/base.yaml") +
                                                      " there (" + path("own.yaml") + ":2)");
  EXPECT_EQ(error_of("extends: ./base.yaml"),
            "extends: no file " + path("base.yaml") + " (" + path("own.yaml") + ":1)");
}

TEST_F(YamlExtendsTest, RefusesWhatIsNoNameOfAFile) {
  for (const char* bad : {"extends: {a: 1}", "extends: []", "extends: [[a]]", "extends:"}) {
    EXPECT_THAT(error_of(bad), HasSubstr("extends: must be a file or a list of files")) << bad;
  }
}

TEST_F(YamlExtendsTest, RefusesACircleAndNamesItsFiles) {
  write("one.yaml", "extends: two.yaml");
  write("two.yaml", "\nextends: ./one.yaml");
  EXPECT_EQ(error_of("extends: one.yaml"), "extends: goes in a circle: " + path("one.yaml") +
                                               " extends " + path("two.yaml") + " extends " +
                                               path("one.yaml") + " (" + path("two.yaml") + ":2)");
  EXPECT_THAT(error_of("extends: own.yaml"), HasSubstr("goes in a circle"));
}

TEST_F(YamlExtendsTest, RefusesHundredsOfFiles) {
  write("0.yaml", "a: 1");
  for (int i = 1; i < 20; ++i) {
    const std::string below = std::to_string(i - 1) + ".yaml";
    write(std::to_string(i) + ".yaml", "extends: [" + below + ", " + below + "]");
  }
  EXPECT_THAT(error_of("extends: 19.yaml"), HasSubstr("extends: more than 100 files"));
}

TEST_F(YamlExtendsTest, AMistakeInABaseHasItsFileAndLine) {
  write("base.yaml", "a: 1\nb: }\n");
  EXPECT_THAT(error_of("extends: base.yaml"),
              AllOf(StartsWith(path("base.yaml") + ":2"), HasSubstr("not valid YAML")));
}

TEST_F(YamlExtendsTest, AnEntryWithoutANameCannotBeMerged) {
  write("base.yaml", "parts: [a]");
  EXPECT_THAT(error_of("extends: base.yaml\nparts: [[b]]"),
              AllOf(StartsWith("parts.*: an entry has no name ("), EndsWith("own.yaml:2)")));
}

TEST_F(YamlExtendsTest, TheBaseMayBePreparedForWhatIsMergedIntoIt) {
  rules_.prepare = [](const YAML::Node&, const YAML::Node&) { return YAML::Load("{a: prepared}"); };
  write("base.yaml", "a: 1");
  EXPECT_EQ(merged("extends: base.yaml\nb: 2"), "{a: prepared, b: 2}");
}

}  // namespace
}  // namespace tocsin
