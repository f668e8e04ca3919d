// SPDX-License-Identifier: Apache-2.0
#include "kobuki_driver/inquiry.hpp"

#include <gtest/gtest.h>

namespace tocsin::kobuki {
namespace {

const Time t0 = Time{} + seconds(100);

/// Requests in `duration_s` when asked every 20 ms.
int requests(Inquiry& sut, double from_s, double to_s) {
  int count = 0;
  for (double t = from_s; t < to_s; t += 0.02) count += sut.due(t0 + seconds(t)).has_value();
  return count;
}

Feedback versions(int minor) {
  Feedback feedback;
  feedback.hardware = Version{1, 0, 4, {}};
  feedback.firmware = Version{1, static_cast<std::uint8_t>(minor), 0, {}};
  feedback.unique_id = UniqueId{1, 2, 3};
  return feedback;
}

TEST(Inquiry, BacksOffWhenNobodyAnswers) {
  Inquiry sut;
  sut.begin(t0);
  const auto request = sut.due(t0);
  ASSERT_TRUE(request);
  EXPECT_EQ(std::get<RequestExtra>(*request).flags, 0x0B);
  EXPECT_LE(requests(sut, 0.02, 10), 7);
  EXPECT_LE(requests(sut, 10, 60), 6);
  EXPECT_GE(requests(sut, 60, 100), 3);  // but never gives up
  Inquiry gains;
  gains.begin(t0);
  gains.on_feedback(versions(2));
  EXPECT_LE(requests(gains, 0, 10), 8);
}

TEST(Inquiry, AsksModernFirmwareForGainsOnce) {
  Inquiry sut;
  sut.begin(t0);
  (void)sut.due(t0);
  sut.on_feedback(versions(2));
  const auto request = sut.due(t0 + seconds(0.02));
  ASSERT_TRUE(request);
  EXPECT_TRUE(std::holds_alternative<GetGains>(*request));
  Feedback gains;
  gains.gains = ControllerGains{};
  sut.on_feedback(gains);
  EXPECT_EQ(requests(sut, 0.04, 100), 0);
}

TEST(Inquiry, AsksOnceMoreForAFirmwareThatIsDoubted) {
  Inquiry sut;
  sut.begin(Time{} + seconds(1));
  Feedback feedback;
  feedback.hardware = feedback.firmware = Version{1, 1, 0, {}};
  feedback.unique_id = UniqueId{};
  sut.on_feedback(feedback);
  EXPECT_FALSE(sut.due(Time{} + seconds(100)));
  sut.doubt_firmware();
  EXPECT_TRUE(sut.due(Time{} + seconds(100)));
  sut.on_feedback(feedback);
  EXPECT_FALSE(sut.due(Time{} + seconds(200)));
}

TEST(Inquiry, NeverAsksOldFirmwareForGains) {
  Inquiry sut;
  sut.begin(t0);
  (void)sut.due(t0);
  sut.on_feedback(versions(1));  // the reference asks 50 times a second for ever
  EXPECT_EQ(requests(sut, 0, 100), 0);
}

TEST(Inquiry, AsksAgainAfterAReconnection) {
  Inquiry sut;
  sut.begin(t0);
  sut.on_feedback(versions(1));
  EXPECT_TRUE(sut.firmware());
  sut.begin(t0 + seconds(5));
  EXPECT_FALSE(sut.firmware());
  EXPECT_TRUE(sut.due(t0 + seconds(5)));
}

}  // namespace
}  // namespace tocsin::kobuki
