// SPDX-License-Identifier: Apache-2.0
#include "mapping/scan_matcher.hpp"

#include <gtest/gtest.h>

#include "drawn_world.hpp"
#include "mapping/submap.hpp"

namespace tocsin::mapping {
namespace {

using geometry::Pose;

/// A field of what a laser sees all round from `pose`.
LikelihoodField field_of(const std::vector<Segment>& walls, const Pose& pose) {
  std::mt19937 random(1);
  Laser all_round{720, 2 * pi, 0.005, 30};
  LikelihoodField field(0.05, 0.1);
  field.stamp(
      laser::transformed(laser::joined(scan_of(walls, pose, all_round, random).hits, 0.05), pose));
  return field;
}

Points seen_from(const std::vector<Segment>& walls, const Pose& pose, double range_m = 30) {
  std::mt19937 random(2);
  return laser::thinned(scan_of(walls, pose, {180, pi, 0.01, range_m}, random).hits, 0.1);
}

std::vector<Segment> corridor() { return {{{-50, -1}, {50, -1}}, {{-50, 1}, {50, 1}}}; }

/// Of a drive along it, so that its walls have no gaps.
LikelihoodField corridor_field() {
  std::mt19937 random(1);
  LikelihoodField field(0.05, 0.1);
  for (double x_m = -4; x_m < 4; x_m += 0.37) {
    const Scan scan = scan_of(corridor(), {x_m, 0, 0}, {720, 2 * pi, 0.005, 30}, random);
    field.stamp(laser::transformed(laser::joined(scan.hits, 0.05), {x_m, 0, 0}));
  }
  return field;
}

double off_m(const Pose& a, const Pose& b) { return geometry::distance(position(a), position(b)); }
double off_rad(const Pose& a, const Pose& b) {
  return std::abs(geometry::wrap_angle(a.heading_rad - b.heading_rad));
}

const Pose truth{4, 2.5, 0.4};

TEST(Search, FindsTheVehicleWithinItsWindow) {
  const auto field = field_of(room(), {3.5, 2.2, 0});
  const FieldBounds bounds(field);
  const Points points = seen_from(room(), truth);
  for (const Pose& guess : {truth, Pose{4.4, 2.2, 0.7}, Pose{3.6, 2.9, 0.05}}) {
    const auto match = search(bounds, points, guess, {0.5, 0.4});
    ASSERT_TRUE(match);
    EXPECT_LT(off_m(match->pose, truth), 0.06);
    EXPECT_LT(off_rad(match->pose, truth), 0.02);
  }
}

TEST(Search, FindsNothingWhenNoPoseIsGoodEnough) {
  const auto field = field_of(room(), {3.5, 2.2, 0});
  const FieldBounds bounds(field);
  SearchParams params;
  params.min_score = 0.3;
  const Points outside = seen_from(room(), truth);
  EXPECT_FALSE(search(bounds, outside, {40, 40, 0}, {0.5, 0.4}, params));
  params.min_score = 0.99;
  EXPECT_FALSE(search(bounds, outside, truth, {0.5, 0.4}, params));
  EXPECT_FALSE(search(bounds, {}, truth, {0.5, 0.4}));
}

TEST(Search, MissesNoPoseThatIsBetter) {
  const auto field = field_of(room(), {3.5, 2.2, 0});
  const FieldBounds bounds(field);
  const Points points = seen_from(room(), truth);
  const Pose guess{4.2, 2.3, 0.5};
  const double turn_rad = 0.1;
  double best = 0;  // of all cells and headings, by the field alone
  double reach_m = 0;
  for (const auto& p : points) reach_m = std::max(reach_m, std::hypot(p.x_m, p.y_m));
  const double step_rad = 0.05 / std::min(reach_m, SearchParams{}.resolved_range_m);
  const int headings = static_cast<int>(std::ceil(turn_rad / step_rad));
  for (int h = -headings; h <= headings; ++h) {
    for (int row = -8; row <= 8; ++row) {
      for (int column = -8; column <= 8; ++column) {
        double sum = 0;
        const Pose pose{guess.x_m, guess.y_m, guess.heading_rad + h * step_rad};
        for (const auto& p : laser::transformed(points, pose)) {
          auto cell = field.grid().cell_of(p);
          if (!cell) continue;
          cell = {cell->column + column, cell->row + row};
          if (field.grid().contains(*cell)) sum += field.cells()[field.grid().offset(*cell)];
        }
        best = std::max(best, sum / (255 * static_cast<double>(points.size())));
      }
    }
  }
  const auto match = search(bounds, points, guess, {0.4, turn_rad});
  ASSERT_TRUE(match);
  EXPECT_NEAR(match->score, best, 1e-9);
}

TEST(Search, LooksForTheSecondBestBesideWhatIsExcluded) {
  const auto field = field_of(room(), {3.5, 2.2, 0});
  const FieldBounds bounds(field);
  const Points points = seen_from(room(), truth);
  SearchParams params;
  params.min_score = 0;
  params.excluded = truth;
  params.excluded_window = {0.3, 0.3};
  const auto second = search(bounds, points, truth, {1, 0.4}, params);
  ASSERT_TRUE(second);
  EXPECT_TRUE(off_m(second->pose, truth) >= 0.3 || off_rad(second->pose, truth) >= 0.3);
  EXPECT_LT(second->score, 0.7);
}

TEST(Search, HoldsToTheGuessWhereThePointsTellNothing) {
  const auto field = corridor_field();
  const FieldBounds bounds(field);
  const Points points = seen_from(corridor(), {0, 0.2, 0}, 6);
  SearchParams params;
  params.guess_weight = 0.05;
  for (const double x_m : {-0.3, 0.0, 0.25}) {
    const auto match = search(bounds, points, {x_m, 0, 0}, {0.5, 0.2}, params);
    ASSERT_TRUE(match);
    EXPECT_NEAR(match->pose.x_m, x_m, 0.11);
    EXPECT_NEAR(match->pose.y_m, 0.2, 0.06);
  }
}

TEST(Refine, ReachesTheTruthFromACellAway) {
  const auto field = field_of(room(), {3.5, 2.2, 0});
  const Points points = seen_from(room(), truth);
  for (const Pose& off : {Pose{0.06, 0, 0}, Pose{-0.05, 0.05, 0.03}, Pose{0, -0.08, -0.03}}) {
    const Pose start{truth.x_m + off.x_m, truth.y_m + off.y_m, truth.heading_rad + off.heading_rad};
    const Match match = refine(field, points, start, start);
    EXPECT_LT(off_m(match.pose, truth), 0.01);
    EXPECT_LT(off_rad(match.pose, truth), 0.005);
    EXPECT_GT(match.score, 0.7);
  }
}

TEST(Refine, DoesNotFindItFromFarAway) {
  const auto field = field_of(room(), {3.5, 2.2, 0});
  const Pose start{truth.x_m + 0.8, truth.y_m, truth.heading_rad + 0.5};
  EXPECT_GT(off_m(refine(field, seen_from(room(), truth), start, start).pose, truth), 0.1);
}

TEST(Refine, KnowsWhichDirectionItCannotTell) {
  const auto across =
      refine(corridor_field(), seen_from(corridor(), {0, 0, 0}, 6), {0, 0, 0}, {0, 0, 0});
  EXPECT_GT(across.information(1, 1), 100 * across.information(0, 0));
  const auto both = refine(field_of(room(), {3.5, 2.2, 0}), seen_from(room(), truth), truth, truth);
  EXPECT_LT(both.information(1, 1), 20 * both.information(0, 0));
}

TEST(Refine, IsHeldByTheGuessAlongACorridor) {
  const Pose guess{0.07, 0, 0};
  const Match match =
      refine(corridor_field(), seen_from(corridor(), {0, 0, 0}, 6), {0, 0, 0}, guess, {0.05, 0.05});
  EXPECT_NEAR(match.pose.x_m, guess.x_m, 0.03);
}

TEST(Refine, TakesBeamsThatLieFarApartForMoreWhenTheyAreNotJoined) {
  const Points points = seen_from(corridor(), {0, 0, 0}, 6);
  const auto along = [&](const Points& stamped) {
    LikelihoodField field(0.05, 0.1);
    field.stamp(stamped);
    return refine(field, points, {0, 0, 0}, {0, 0, 0}).information(0, 0);
  };
  EXPECT_GT(along(points), 3 * along(laser::joined(points, 0.05)));
}

TEST(Refine, OfNoPointsStaysAndKnowsNothing) {
  const Match match = refine(LikelihoodField(0.05, 0.1), {}, truth, truth);
  EXPECT_EQ(match.pose.x_m, truth.x_m);
  EXPECT_EQ(match.score, 0);
  EXPECT_EQ(match.information.norm(), 0);
}

TEST(IsSure, WhatFitsNearItsGuessIs) {
  const auto field = field_of(room(), {3.5, 2.2, 0});
  const Pose guess{truth.x_m + 0.03, truth.y_m - 0.04, truth.heading_rad + 0.02};
  const Match match = refine(field, seen_from(room(), truth), guess, guess);
  EXPECT_LT(off_m(match.pose, truth), 0.02);
  EXPECT_TRUE(is_sure(match, guess, field, 0.6));
}

TEST(IsSure, WhatFitsBadlyOrFarFromItsGuessIsNot) {
  const auto field = field_of(room(), {3.5, 2.2, 0});
  Match match;
  match.pose = truth;
  match.score = 0.7;
  EXPECT_TRUE(is_sure(match, truth, field, 0.6));
  EXPECT_FALSE(is_sure(match, truth, field, 0.71));
  EXPECT_FALSE(is_sure(match, {truth.x_m + 0.11, truth.y_m, 0}, field, 0.6));
}

}  // namespace
}  // namespace tocsin::mapping
