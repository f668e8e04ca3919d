// SPDX-License-Identifier: Apache-2.0
// Which topics are shown where there is no room for all.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "live_view/screen.hpp"
#include "view_state.hpp"

namespace tocsin {
namespace {

using terminal::Size;
using ::testing::HasSubstr;

std::vector<std::string> lines_of(const ViewState& state, Size size) {
  return terminal::to_texts(page(state, t0, size, limits), size, false);
}

/// 20 topics of which only the last, the camera, carries anything.
ViewState with_idle_topics() {
  ViewState state = full_state();
  state.traffic.assign(20, camera_row());
  for (std::size_t i = 0; i < state.traffic.size(); ++i) {
    TrafficRow& row = state.traffic[i];
    row.topic = fmt::format("topic_{:02}", i);
    row.rate_hz = 0;
    row.paused = false;
    row.sent = row.received = 3;
  }
  state.traffic.back() = camera_row();
  return state;
}

TEST(ScreenRoom, WhereThereIsNoRoomTheIdleTopicsGoFirst) {
  const auto lines = lines_of(with_idle_topics(), {80, 24});
  ASSERT_EQ(lines.size(), 24U);
  EXPECT_THAT(lines[6], HasSubstr("camera/image_raw"));
  EXPECT_THAT(lines[7], HasSubstr("topic_00"));
  EXPECT_EQ(lines[23], "and 3 topics more");
}

TEST(ScreenRoom, ATopicThatIsPausedOrLosesSamplesIsNotIdle) {
  ViewState state = with_idle_topics();
  state.traffic[17].paused = true;
  state.traffic[18].sent = 4;
  const auto lines = lines_of(state, {80, 24});
  EXPECT_THAT(lines[6], HasSubstr("topic_17"));
  EXPECT_THAT(lines[7], HasSubstr("topic_18"));
}

}  // namespace
}  // namespace tocsin
