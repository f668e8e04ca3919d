// SPDX-License-Identifier: Apache-2.0
#include "dot.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

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

TEST(Dot, GroupsByHostAndContainer) {
  const std::string dot = to_dot(mission, false);
  EXPECT_THAT(dot, HasSubstr("cluster_uxv/drive"));
  EXPECT_THAT(dot, HasSubstr("gcs (role gcs)"));
}

TEST(Dot, LeavesOutObserversAndUnreadTopicsUnlessAllAreWanted) {
  EXPECT_THAT(to_dot(mission, false), Not(HasSubstr("recorder")));
  EXPECT_THAT(to_dot(mission, false), Not(HasSubstr("uxv:tf")));
  EXPECT_THAT(to_dot(mission, true), HasSubstr("recorder"));
  EXPECT_THAT(to_dot(mission, true), HasSubstr("uxv:tf"));
}

TEST(Dot, AHostTopicIsDrawnOnEachHost) {
  const Graph graph{vehicle("a", {writes("log")}), vehicle("b", {reads("log")}),
                    station("c", {writes("log")}), station("d", {reads("log")})};
  const std::string dot = to_dot(graph, true);
  EXPECT_THAT(dot, HasSubstr("\"uxv:log\" -> \"uxv/drive/b\""));
  EXPECT_THAT(dot, HasSubstr("\"gcs:log\" -> \"gcs/desk/d\""));
}

}  // namespace
}  // namespace tocsin::check
