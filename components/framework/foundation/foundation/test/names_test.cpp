// SPDX-License-Identifier: Apache-2.0
#include "foundation/names.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::IsEmpty;

TEST(WordsOfPath, LeavesOutEmptyWords) {
  EXPECT_THAT(words_of_path("/uxv/payload"), ElementsAre("uxv", "payload"));
  EXPECT_THAT(words_of_path("uxv//payload/"), ElementsAre("uxv", "payload"));
  EXPECT_THAT(words_of_path("camera"), ElementsAre("camera"));
  EXPECT_THAT(words_of_path("/"), IsEmpty());
  EXPECT_THAT(words_of_path(""), IsEmpty());
}

TEST(Means, AnyPartOfAPathThatEndsWithItsLastWord) {
  for (const char* given : {"camera", "/camera", "payload/camera", "/payload/camera", "uxv/camera",
                            "/uxv/payload/camera", "uxv/payload/camera"}) {
    EXPECT_TRUE(means(given, "uxv/payload/camera")) << given;
  }
}

TEST(Means, NothingElse) {
  for (const char* given :
       {"", "/", "payload", "uxv/payload", "gcs/camera", "camera/payload/camera",
        "payload/uxv/camera", "cam", "camera2", "a/uxv/payload/camera"}) {
    EXPECT_FALSE(means(given, "uxv/payload/camera")) << given;
  }
}

const std::vector<std::string> processes{"uxv/drive", "uxv/link", "gcs/link", "gcs/drive/link"};

std::string refusal(const std::string& given) {
  try {
    return "accepted as " + resolve_path(given, processes, "process");
  } catch (const ConfigError& error) {
    return error.what();
  }
}

TEST(ResolvePath, FindsTheOneThatIsMeant) {
  EXPECT_EQ(resolve_path("drive", processes, "process"), "uxv/drive");
  EXPECT_EQ(resolve_path("/uxv/link", processes, "process"), "uxv/link");
}

TEST(ResolvePath, TheWholePathGoesBeforeAPartOfALongerOne) {
  EXPECT_EQ(resolve_path("gcs/link", processes, "process"), "gcs/link");
}

TEST(ResolvePath, AsksWhenSeveralAreMeant) {
  EXPECT_EQ(refusal("link"), "link: which process? One of [uxv/link, gcs/link, gcs/drive/link]");
}

TEST(ResolvePath, ListsTheChoiceWhenNoneIsMeant) {
  EXPECT_EQ(refusal("uxv/view"),
            "uxv/view: no such process; allowed: [uxv/drive, uxv/link, gcs/link, gcs/drive/link]");
  EXPECT_THAT(refusal("uxv/drvie"), EndsWith("; did you mean 'uxv/drive'?"));
  EXPECT_THAT(refusal("drvie"), EndsWith("; did you mean 'drive'?"));
  EXPECT_EQ(refusal(""),
            ": no such process; allowed: [uxv/drive, uxv/link, gcs/link, gcs/drive/link]");
  EXPECT_EQ(refusal("\x1b[2J").substr(0, 20), "\\x1b[2J: no such pro");
}

TEST(WithoutSlash, TakesTheNameAsRosPrintsIt) {
  EXPECT_EQ(without_slash("/odom"), "odom");
  EXPECT_EQ(without_slash("odom"), "odom");
  EXPECT_EQ(without_slash("/camera/image"), "camera/image");
  EXPECT_EQ(without_slash("/"), "");
}

TEST(Name, IsALowerCaseWordWithDigitsAndUnderscores) {
  for (const char* name : {"a", "kobuki_driver", "wlan0", "a__b_"}) EXPECT_TRUE(is_name(name));
}

TEST(Name, IsNoPathAndNoOtherText) {
  for (const char* text :
       {"", "../a", "a/b", "a.b", "A", "0a", "_a", "a-b", "a b", "a\n", "\xc3\xa4"}) {
    EXPECT_FALSE(is_name(text)) << text;
  }
}

}  // namespace
}  // namespace tocsin
