// SPDX-License-Identifier: Apache-2.0
#include "camera/adaptive_stream.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <tuple>

#include "camera/jpeg.hpp"

namespace tocsin::camera {
namespace {

constexpr Time t0{std::chrono::hours(1)};
constexpr Duration period = std::chrono::milliseconds(125);

/// Pictures and bytes, as shares of what the source would like, over 800 pictures.
struct Sent {
  double pictures = 0;
  double bytes = 0;
};
Sent play(double scale, bool hold = false) {
  AdaptiveStream sut;
  Sent sent;
  Time now = t0;
  for (int i = 0; i < 800; ++i, now += period) {
    sut.set_budget(scale, hold, now);
    const auto share = sut.next(now);
    sent.pictures += share ? 1.0 / 800 : 0;
    sent.bytes += share.value_or(0) / 800;
  }
  return sent;
}

TEST(AdaptiveStream, KeepsToItsBudgetInBytesMoreBySizeThanByRate) {
  for (const auto& [scale, pictures, bytes] : {std::tuple(7.0, 1.0, 1.0),
                                               {1.0, 1.0, 1.0},
                                               {0.5, 0.933, 0.5},
                                               {0.25, 0.871, 0.25},
                                               {-1.0, 0.0, 0.0}}) {
    EXPECT_NEAR(play(scale).bytes, bytes, 0.01) << scale;
    EXPECT_NEAR(play(scale).pictures, pictures, 0.01) << scale;
  }
  EXPECT_EQ(play(1, true).pictures, 0) << "older ones wait";
}

TEST(AdaptiveStream, DoesNotCatchUpWithWhatItSkipped) {
  AdaptiveStream sut;
  for (int i = 0; i < 40; ++i) {
    sut.set_budget(1e-4, true, t0 + i * period);
    EXPECT_FALSE(sut.next(t0 + i * period));
  }
  int sent = 0;
  for (int i = 40; i < 48; ++i) {
    sut.set_budget(1e-4, false, t0 + i * period);
    sent += sut.next(t0 + i * period) ? 1 : 0;
  }
  EXPECT_LE(sent, 5);
}

TEST(AdaptiveStream, ABudgetThatIsNotRenewedIsOver) {
  AdaptiveStream sut;
  sut.set_budget(0.25, true, t0);
  EXPECT_FALSE(sut.next(t0 + std::chrono::seconds(2)));
  EXPECT_EQ(sut.next(t0 + std::chrono::milliseconds(2001)), 1.0);
}

TEST(QualityLaw, IsLinearBetweenWhatItKnows) {
  QualityLaw sut;
  sut.add(10, 100);
  sut.add(30, 300);
  sut.add(65, 1000);
  EXPECT_EQ(sut.quality_for(1), 65);
  EXPECT_EQ(sut.quality_for(0.3), 30);
  EXPECT_EQ(sut.quality_for(0.2), 20);
  EXPECT_EQ(sut.quality_for(0.01), 10);
}

TEST(QualityLaw, MakesPicturesOfAboutTheWantedSize) {
  Picture picture(320, 240);
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      const auto grey = static_cast<std::uint8_t>((x * 7 + y * 13 + (x * y) % 97) & 0xFF);
      std::fill_n(picture.at(x, y), 3, grey);
    }
  }
  QualityLaw sut;
  for (const int quality : {5, 15, 35, 65}) sut.add(quality, encode_jpeg(picture, quality).size());
  const double whole = static_cast<double>(encode_jpeg(picture, 65).size());
  for (const double share : {0.4, 0.6, 0.8}) {
    const auto bytes = encode_jpeg(picture, sut.quality_for(share)).size();
    EXPECT_NEAR(static_cast<double>(bytes) / whole, share, 0.12) << share;
  }
}

}  // namespace
}  // namespace tocsin::camera
