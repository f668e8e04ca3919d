// SPDX-License-Identifier: Apache-2.0
#include "coverage/polygon.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "foundation/error.hpp"

namespace tocsin::coverage {
namespace {

using geometry::Point;

/// Twice the area of the triangle; above 0 when it turns left.
double turn(const Point& a, const Point& b, const Point& c) {
  return (b.x_m - a.x_m) * (c.y_m - a.y_m) - (b.y_m - a.y_m) * (c.x_m - a.x_m);
}

bool is_between(const Point& a, const Point& b, const Point& p) {
  return p.x_m >= std::min(a.x_m, b.x_m) && p.x_m <= std::max(a.x_m, b.x_m) &&
         p.y_m >= std::min(a.y_m, b.y_m) && p.y_m <= std::max(a.y_m, b.y_m);
}

bool meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  const double abc = turn(a, b, c);
  const double abd = turn(a, b, d);
  const double cda = turn(c, d, a);
  const double cdb = turn(c, d, b);
  if (((abc > 0 && abd < 0) || (abc < 0 && abd > 0)) &&
      ((cda > 0 && cdb < 0) || (cda < 0 && cdb > 0))) {
    return true;
  }
  return (abc == 0 && is_between(a, b, c)) || (abd == 0 && is_between(a, b, d)) ||
         (cda == 0 && is_between(c, d, a)) || (cdb == 0 && is_between(c, d, b));
}

/// Sides that share a corner may only have that one in common.
bool folds_back(const Point& a, const Point& b, const Point& c) {
  const double along = (a.x_m - b.x_m) * (c.x_m - b.x_m) + (a.y_m - b.y_m) * (c.y_m - b.y_m);
  return turn(a, b, c) == 0 && along >= 0;
}

/// That the side from corner `i` meets the others at its ends only.
void require_side(const std::vector<Point>& corners, std::size_t i, const char* what) {
  const std::size_t count = corners.size();
  const Point& a = corners[i];
  const Point& b = corners[(i + 1) % count];
  if (folds_back(a, b, corners[(i + 2) % count])) {
    throw ConfigError(fmt::format("{}: folds back at corner {}", what, (i + 1) % count + 1));
  }
  for (std::size_t k = i + 2; k < count; ++k) {
    const bool are_neighbours = i == 0 && k == count - 1;
    if (are_neighbours || !meet(a, b, corners[k], corners[(k + 1) % count])) continue;
    throw ConfigError(
        fmt::format("{}: its sides from corner {} and from corner {} cross", what, i + 1, k + 1));
  }
}

}  // namespace

void require_polygon(const std::vector<Point>& corners, const char* what) {
  const std::size_t count = corners.size();
  if (count < 3 || count > most_corners) {
    throw ConfigError(
        fmt::format("{}: has {} corners, outside [3, {}]", what, count, most_corners));
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (is_finite(corners[i])) continue;
    throw ConfigError(fmt::format("{}: corner {} is ({}, {}), which is not finite", what, i + 1,
                                  corners[i].x_m, corners[i].y_m));
  }
  for (std::size_t i = 0; i < count; ++i) require_side(corners, i, what);
}

bool is_inside(const std::vector<Point>& corners, const Point& p) {
  bool inside = false;
  for (std::size_t i = 0, last = corners.size() - 1; i < corners.size(); last = i++) {
    const Point& a = corners[i];
    const Point& b = corners[last];
    if ((a.y_m > p.y_m) == (b.y_m > p.y_m)) continue;
    const double x_m = a.x_m + (p.y_m - a.y_m) / (b.y_m - a.y_m) * (b.x_m - a.x_m);
    if (p.x_m < x_m) inside = !inside;
  }
  return inside;
}

}  // namespace tocsin::coverage
