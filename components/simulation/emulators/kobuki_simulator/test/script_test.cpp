// SPDX-License-Identifier: Apache-2.0
#include "script.hpp"

#include <gmock/gmock.h>

#include "foundation/error.hpp"

namespace tocsin::kobuki {
namespace {

using ::testing::HasSubstr;

const Time t0 = Time{} + seconds(100);

TEST(Script, HandsOverEachCommandAtItsTime) {
  Script sut("# faults\n1 set bumper=2\n\n1.5 unplug 3  # the cable\n", "f", t0);
  EXPECT_EQ(sut.next(), t0 + seconds(1));
  EXPECT_FALSE(sut.due(t0 + seconds(1) - Duration{1}));
  EXPECT_EQ(sut.due(t0 + seconds(1)), "set bumper=2");
  EXPECT_FALSE(sut.due(t0 + seconds(1.4)));
  EXPECT_EQ(sut.due(t0 + seconds(1.5))->substr(0, 8), "unplug 3");
  EXPECT_EQ(sut.next(), never);
  EXPECT_FALSE(sut.due(t0 + seconds(1000)));
}

TEST(Script, HandsOverAllThatBecameDue) {
  Script sut("0 reset\n0 plug\n", "f", t0);
  EXPECT_EQ(sut.due(t0 + seconds(5)), "reset");
  EXPECT_EQ(sut.due(t0 + seconds(5)), "plug");
}

TEST(Script, MayBeEmpty) {
  Script sut;
  EXPECT_EQ(sut.next(), never);
  EXPECT_FALSE(sut.due(t0));
}

TEST(Script, RefusesWrongLinesWithTheirNumber) {
  for (const char* bad : {"reset", "-1 reset", "nan reset", "3", "3   ", "5 plug\n4 plug"}) {
    try {
      Script sut(std::string("0 plug\n") + bad, "faults.txt", t0);
      FAIL() << bad;
    } catch (const ConfigError& error) {
      EXPECT_THAT(error.what(), HasSubstr("faults.txt:")) << bad;
    }
  }
}

}  // namespace
}  // namespace tocsin::kobuki
