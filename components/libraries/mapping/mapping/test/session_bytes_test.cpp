// SPDX-License-Identifier: Apache-2.0
#include "mapping/session_bytes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <string_view>

#include "drawn_world.hpp"
#include "foundation/error.hpp"
#include "foundation/hash.hpp"
#include "mapping/mapper.hpp"

namespace tocsin::mapping {
namespace {

using geometry::compose;
using geometry::Pose;
using ::testing::HasSubstr;

/// Drives through the drawn room from x = 1 m on.
GlobalMapper driven(double to_x_m) {
  LocalMapper local({}, Pose{1, 1, 0});
  GlobalMapper global;
  std::mt19937 random(1);
  for (double x_m = 1; x_m < to_x_m; x_m += 0.11) {
    auto step = local.on_scan({x_m, 1, 0}, scan_of(room(), {x_m, 1, 0}, {}, random));
    if (step) global.add(std::move(*step));
  }
  return global;
}

std::string error_of(const std::string& bytes) {
  try {
    (void)session_in(bytes, "a.session");
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "no error";
}

/// A check sum that fits, so that what the sum protects is looked at.
std::string signed_anew(std::string bytes) {
  const std::size_t header = std::string("tocsin map session 1\n").size();
  const std::uint64_t sum = hash_of(std::string_view(bytes).substr(header + 8));
  std::memcpy(&bytes[header], &sum, 8);
  return bytes;
}

TEST(SessionBytes, AMapGoesOnWhereItWasKept) {
  const GlobalMapper before = driven(6);
  ASSERT_GE(before.submaps().size(), 3U);
  GlobalMapper sut({}, session_in(bytes_of(before.session()), "a.session"));
  EXPECT_EQ(sut.nodes().size(), before.nodes().size());
  EXPECT_EQ(sut.submaps().size(), before.submaps().size());
  EXPECT_EQ(sut.graph().constraints().size(), before.graph().constraints().size());
  EXPECT_EQ(bytes_of(sut.session()), bytes_of(before.session()));

  // From another place, told half a metre wrong.
  std::mt19937 random(2);
  Pose truth{4, 1.5, 2};
  const auto scan_at = [&](const Pose& pose) { return scan_of(room(), pose, {}, random); };
  const auto start = sut.locate(scan_at(truth), {4.4, 1.2, 1.8}, 4, {1.0, 0.5});
  ASSERT_TRUE(start);
  EXPECT_LT(geometry::distance(position(*start), position(truth)), 0.05);
  LocalMapper local({}, start, sut.nodes().size());
  Pose odometry{};
  for (int i = 0; i < 15; ++i) {
    auto step = local.on_scan(odometry, scan_at(truth));
    ASSERT_TRUE(step);
    sut.add(std::move(*step));
    truth = compose(truth, {0.1, 0, 0.08});
    odometry = compose(odometry, {0.105, 0, 0.08});
  }
  EXPECT_LT(
      geometry::distance(position(compose(sut.poses().back(), {0.1, 0, 0.08})), position(truth)),
      0.05);
}

TEST(SessionBytes, NothingIsLocatedWhereTheMapIsAnother) {
  const GlobalMapper sut = driven(6);
  std::mt19937 random(2);
  const auto other = closed({{0, 0}, {11, 1}, {9, 4}, {3, 7}, {-1, 3}});
  EXPECT_FALSE(sut.locate(scan_of(other, {4, 2.5, 0}, {}, random), {4, 2.5, 0}, 4, {1.0, 0.5}));
  EXPECT_FALSE(sut.locate(scan_of(room(), {4, 1.5, 0}, {}, random), {40, 1.5, 0}, 4, {1.0, 0.5}));
}

TEST(SessionBytes, RefusesWhatIsCutDamagedOrOfAnotherKind) {
  const std::string whole = bytes_of(driven(4).session());
  EXPECT_EQ(error_of(whole), "no error");
  EXPECT_THAT(error_of(""), HasSubstr("a.session: is no session of a map: it does not begin with"));
  EXPECT_THAT(error_of("image: m.pgm\n"), HasSubstr("does not begin"));
  for (const std::size_t length :
       {std::size_t{21}, std::size_t{29}, whole.size() / 2, whole.size() - 1}) {
    EXPECT_THAT(error_of(whole.substr(0, length)), HasSubstr("cut"));
  }
  std::string damaged = whole;
  damaged[damaged.size() / 2] ^= 1;
  EXPECT_THAT(error_of(damaged), HasSubstr("check sum"));
  EXPECT_THAT(error_of(whole + "x"), HasSubstr("check sum"));
  EXPECT_THAT(error_of(signed_anew(whole + "x")), HasSubstr("longer"));
}

TEST(SessionBytes, RefusesWhatContradictsItselfThoughTheCheckSumFits) {
  const MapSession whole = driven(4).session();
  const auto error_after = [&](const auto& change) {
    MapSession session = whole;
    change(session);
    return error_of(bytes_of(session));
  };
  EXPECT_THAT(error_after([](auto& s) { s.nodes[1].pose.x_m = infinity; }),
              HasSubstr("a pose is not"));
  EXPECT_THAT(error_after([](auto& s) { s.submaps[0].back() = 1000; }), HasSubstr("not there"));
  EXPECT_THAT(error_after([](auto& s) { s.submaps[0] = {1, 1}; }), HasSubstr("do not rise"));
  EXPECT_THAT(error_after([](auto& s) { s.submaps[0].clear(); }), HasSubstr("has no node"));
  EXPECT_THAT(error_after([](auto& s) { s.constraints[0].to = 1000; }), HasSubstr("not there"));
  EXPECT_THAT(error_after([](auto& s) { s.constraints[0].from = s.constraints[0].to; }),
              HasSubstr("itself"));
  EXPECT_THAT(error_after([](auto& s) { s.constraints[0].information(1, 1) = nan; }),
              HasSubstr("not finite"));
  std::string many = bytes_of(whole);
  many[21 + 8 + 6] = '\x7f';
  EXPECT_THAT(error_of(signed_anew(many)), HasSubstr("longer than the file"));
}

}  // namespace
}  // namespace tocsin::mapping
