// SPDX-License-Identifier: Apache-2.0
#include "radio_link.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

namespace tocsin::simulation {
namespace {

class RadioLinkTest : public ::testing::Test {
 protected:
  void run_for(double s) {
    const Time end = core_.now + seconds(s);
    const auto next = [this] { return std::min(core_.events.next(), sut_.next_event()); };
    for (Time at = next(); at <= end; at = next()) {
      core_.now = std::max(core_.now, at);
      core_.events.run(core_.now);
      sut_.advance();
    }
    core_.now = end;
  }
  void send(const Way& way, char name) {
    sut_.send(way, 500, [this, name] { arrived_ += name; });
  }

  Core core_;
  RadioLink sut_{core_, radio::ChannelParams{}, {{}, 1, 1}};
  std::string arrived_;
};

TEST_F(RadioLinkTest, DeliversNearTheAccessPointInOrder) {
  for (const char name : std::string("abcdef")) send(radio::Direction::uplink, name);
  EXPECT_EQ(arrived_, "");
  run_for(1);
  EXPECT_EQ(arrived_, "abcdef");
  EXPECT_EQ(sut_.pushed(), 6U);
}

TEST_F(RadioLinkTest, PacketSentOnArrivalArrivesToo) {
  sut_.send(radio::Direction::uplink, 500, [this] { send(back(radio::Direction::uplink), 'r'); });
  run_for(1);
  EXPECT_EQ(arrived_, "r");
}

TEST_F(RadioLinkTest, AnswersHaveTheDscpOfWhatTheyAnswer) {
  const Way way(radio::Direction::uplink, 48);
  EXPECT_EQ(back(way).direction, radio::Direction::downlink);
  EXPECT_EQ(back(way).dscp, 48);
  EXPECT_EQ(Way(radio::Direction::uplink).dscp, 0);
}

/// The order in which 'v' of CS6 arrives that was sent after twenty others of CS1.
std::string arrivals_with(bool access_categories) {
  Core core;
  radio::ChannelParams params;
  params.access_categories = access_categories;
  RadioLink sut(core, params, {{}, 1, 1});
  std::string arrived;
  const auto send = [&](std::uint8_t dscp, char name) {
    sut.send({radio::Direction::uplink, dscp}, 1400, [&arrived, name] { arrived += name; });
  };
  for (int i = 0; i < 20; ++i) send(8, 'b');
  send(48, 'v');
  core.now += seconds(1);
  sut.advance();
  return arrived;
}

TEST(RadioLink, UrgentPacketsGoFirstWhereTheChannelHasAccessCategories) {
  EXPECT_LE(arrivals_with(true).find('v'), 2U);  // one of the others is on the air
  EXPECT_EQ(arrivals_with(false).find('v'), 20U);
}

TEST_F(RadioLinkTest, DoesAllUntilAPacketArrivesAndNothingBeyondTheLimit) {
  send(radio::Direction::uplink, 'a');
  sut_.advance();  // the packet is under way
  const Time limit = core_.now + Duration{1};
  EXPECT_EQ(sut_.next_arrival(limit), limit);
  core_.now = sut_.next_arrival(core_.now + seconds(1));
  EXPECT_LT(core_.now, start_time + seconds(1));
  EXPECT_EQ(arrived_, "");
  sut_.advance();
  EXPECT_EQ(arrived_, "a");
  EXPECT_EQ(sut_.next_arrival(core_.now + seconds(1)), core_.now + seconds(1));
}

/// Notes what comes.
class Parts final : public Cargo {
 public:
  explicit Parts(std::size_t count) : left_(count) {}
  void arrive(std::size_t) override { --left_; }
  [[nodiscard]] bool waits_after(std::size_t) const override { return left_ > 1; }
  [[nodiscard]] std::size_t left() const { return left_; }

 private:
  std::size_t left_;
};

TEST_F(RadioLinkTest, RunsOnToTheLastPartOfACargoUnlessTheAirHasFaults) {
  const auto send_parts = [this] {
    const auto parts = std::make_shared<Parts>(3);
    for (std::size_t i = 0; i < 3; ++i) sut_.send(radio::Direction::uplink, 500, parts, i);
    core_.now = sut_.next_arrival(core_.now + seconds(1));
    return parts;
  };
  const auto parts = send_parts();
  EXPECT_EQ(parts->left(), 1U);
  sut_.advance();
  EXPECT_EQ(parts->left(), 0U);
  sut_.faults(0).duplication = 0.5;
  EXPECT_EQ(send_parts()->left(), 3U);
}

TEST_F(RadioLinkTest, RunsOnOverPacketsThatAreLost) {
  sut_.set_position(20'000, 0, 0);
  send(radio::Direction::uplink, 'a');
  EXPECT_EQ(sut_.next_arrival(core_.now + seconds(1)), core_.now + seconds(1));
  EXPECT_EQ(sut_.next_event(), never);
  EXPECT_EQ(arrived_, "");
}

TEST_F(RadioLinkTest, TellsTheSignalAndZerosWithoutDotsWhenNotAssociated) {
  sut_.set_position(3, 0, 0);
  run_for(2.5);
  EXPECT_NE(sut_.wireless_text(0).find(".  -256"), std::string::npos) << sut_.wireless_text(0);
  sut_.set_position(20'000, 0, 0);
  run_for(2.5);
  EXPECT_EQ(sut_.wireless_text(0).find("-256"), std::string::npos) << sut_.wireless_text(0);
}

}  // namespace
}  // namespace tocsin::simulation
