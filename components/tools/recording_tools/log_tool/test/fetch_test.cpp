// SPDX-License-Identifier: Apache-2.0
#include "fetch.hpp"

#include <gmock/gmock.h>

namespace tocsin::log_tool {
namespace {

constexpr Time t0{std::chrono::hours(1)};
constexpr Duration s = std::chrono::seconds(1);

class FetchTest : public ::testing::Test {
 protected:
  static tocsin_msgs::msg::LogRequest request() {
    tocsin_msgs::msg::LogRequest request;
    request.id(41);
    request.topic("odom");
    return request;
  }
  static tocsin_msgs::msg::LinkState state(const char* word, std::uint64_t found,
                                           std::uint64_t delivered, const char* role = "uxv",
                                           std::uint64_t id = 41) {
    tocsin_msgs::msg::LogFetch fetch;
    fetch.id(id);
    fetch.state(word);
    fetch.found(found);
    fetch.delivered(delivered);
    fetch.gone(1);
    tocsin_msgs::msg::LinkState state;
    state.role(role);
    state.fetches({fetch});
    return state;
  }
  Fetch sut_{request()};
};

TEST_F(FetchTest, IsDoneWhenAllWhoKnowItSayThatItIs) {
  EXPECT_FALSE(sut_.is_done());
  sut_.on_state(state("done", 3, 3, "uxv", 42), t0);
  EXPECT_FALSE(sut_.is_done()) << "another request";
  sut_.on_state(state("done", 3, 3), t0);
  sut_.on_state(state("sending", 5, 1, "gcs"), t0);
  EXPECT_FALSE(sut_.is_done());
  EXPECT_EQ(sut_.found(), 8U);
  EXPECT_EQ(sut_.delivered(), 4U);
  EXPECT_EQ(sut_.gone(), 2U);
  sut_.on_state(state("done", 5, 5, "gcs"), t0);
  EXPECT_TRUE(sut_.is_done());
}

TEST_F(FetchTest, TellsHowFarItIsWhenThatChanges) {
  EXPECT_TRUE(sut_.has_to_ask(t0));
  EXPECT_EQ(sut_.news(t0), "");
  sut_.on_state(state("sending", 10, 2), t0);
  EXPECT_EQ(sut_.news(t0), "2 of 10 samples have crossed");
  EXPECT_EQ(sut_.news(t0), "");
  sut_.on_state(state("sending", 10, 4), t0);
  EXPECT_EQ(sut_.news(t0), "4 of 10 samples have crossed");
}

TEST_F(FetchTest, TellsThatNobodyAnswers) {
  EXPECT_TRUE(sut_.has_to_ask(t0));
  EXPECT_EQ(sut_.news(t0 + 5 * s), "");
  EXPECT_EQ(sut_.news(t0 + 6 * s), "no word of the log for 6 s");
  sut_.on_state(state("sending", 1, 0), t0 + 7 * s);
  EXPECT_EQ(sut_.news(t0 + 7 * s), "0 of 1 samples have crossed");
}

}  // namespace
}  // namespace tocsin::log_tool
