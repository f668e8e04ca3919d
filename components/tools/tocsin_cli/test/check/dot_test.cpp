// SPDX-License-Identifier: Apache-2.0
#include "dot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

#include "graphs.hpp"

namespace tocsin::check {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const Graph mission{vehicle("driver", {writes("odom"), writes("tf")}),
                    vehicle("navigator", {reads("odom"), writes("location", Scope::link)}),
                    station("control", {reads("location", Scope::link), writes("status")}),
                    station("recorder", {reads("location", Scope::link)})};

TEST(Dot, DrawsEachEndOfATopic) {
  const std::string dot = to_dot(mission, false);
  EXPECT_THAT(dot, HasSubstr("\"uxv/drive/driver\" -> \"uxv:odom\""));
  EXPECT_THAT(dot, HasSubstr("\"uxv:odom\" -> \"uxv/drive/navigator\""));
  EXPECT_THAT(dot, HasSubstr("\":location\" -> \"gcs/desk/control\""));
}

TEST(Dot, LeavesOutObserversAndUnreadTopicsUnlessAllAreWanted) {
  EXPECT_THAT(to_dot(mission, false), Not(HasSubstr("recorder")));
  EXPECT_THAT(to_dot(mission, false), Not(HasSubstr("uxv:tf")));
  EXPECT_THAT(to_dot(mission, true), HasSubstr("recorder"));
  EXPECT_THAT(to_dot(mission, true), HasSubstr("uxv:tf"));
}

TEST(DrawSvg, SaysWhichFileItCouldNotWrite) {
  try {
    draw_svg(to_dot(mission, false), "/nowhere/a.svg");
    FAIL() << "no error";
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/a.svg: "));
  }
}

}  // namespace
}  // namespace tocsin::check
