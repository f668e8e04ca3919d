// SPDX-License-Identifier: Apache-2.0
#include "foundation/enum_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "foundation/error.hpp"
#include "foundation/parameters.hpp"

namespace tocsin {
namespace {

enum class Colour { red, deep_blue, green };
constexpr std::array<const char*, 3> words_of(Colour) { return {"red", "deep_blue", "green"}; }

struct Params {
  Colour colour = Colour::deep_blue;
  template <class Visitor>
  void visit(Visitor& v) {
    visit_enum(v, "colour", colour, Choices{"red", "deep_blue"}, "of the lamp");
  }
};

Params load(const std::string& text) {
  YamlSources sources;
  return load_parameters<Params>(sources.parse(text, "file"), "lamp", sources);
}

TEST(EnumWords, EachValueHasAWordThatNamesIt) {
  EXPECT_STREQ(word_of(Colour::deep_blue), "deep_blue");
  EXPECT_EQ(value_of<Colour>("green"), Colour::green);
  EXPECT_FALSE(value_of<Colour>("Green"));
}

TEST(EnumWords, AParameterIsReadAndPrintedAsAWord) {
  EXPECT_EQ(load("{}").colour, Colour::deep_blue);
  EXPECT_EQ(load("colour: red").colour, Colour::red);
  EXPECT_THAT(default_yaml<Params>(), ::testing::HasSubstr("colour: deep_blue"));
}

TEST(EnumWords, AWordThatIsNotAllowedIsAnErrorThatNamesThoseThatAre) {
  EXPECT_THAT([] { (void)load("colour: green"); },
              ::testing::ThrowsMessage<ConfigError>(
                  ::testing::HasSubstr("lamp.colour: 'green' is not one of: red, deep_blue")));
}

}  // namespace
}  // namespace tocsin
