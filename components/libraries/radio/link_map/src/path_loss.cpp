// SPDX-License-Identifier: Apache-2.0
#include "link_map/path_loss.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "foundation/numbers.hpp"

namespace tocsin::link_map {
namespace {

using geometry::Point;

constexpr double around_m = 15;
constexpr double lattice_m = 2.5;
constexpr int steps = 15;            // of a site that is larger
constexpr double residual_db2 = 36;  // of signals around a path loss, for the hold on n

struct Fit {
  PathLoss path_loss;
  double cost = infinity;
};

/// Least squares of K and n, n held near what is usual.
Fit fit_at(const Point& access_point, const std::vector<Point>& places,
           const Eigen::VectorXd& signals_dbm) {
  Fit fit;
  fit.path_loss.access_point = access_point;
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  normal(1, 1) = residual_db2;
  right(1) = residual_db2 * usual_exponent;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Eigen::Vector2d basis = fit.path_loss.basis(places[i]);
    normal += basis * basis.transpose();
    right += basis * signals_dbm(static_cast<Eigen::Index>(i));
  }
  const Eigen::Vector2d solved = normal.inverse() * right;
  fit.path_loss.exponent = std::clamp(solved(1), 1.0, 6.0);
  const double count = std::max<double>(1, static_cast<double>(places.size()));
  double sum = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    sum += signals_dbm(static_cast<Eigen::Index>(i)) -
           fit.path_loss.basis(places[i])(1) * fit.path_loss.exponent;
  }
  fit.path_loss.at_1_m_dbm = sum / count;
  const double off = fit.path_loss.exponent - usual_exponent;
  fit.cost = residual_db2 * off * off;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double miss =
        signals_dbm(static_cast<Eigen::Index>(i)) - fit.path_loss.signal_dbm(places[i]);
    fit.cost += miss * miss;
  }
  return fit;
}

}  // namespace

Eigen::Vector2d PathLoss::basis(const Point& at) const {
  return {1, -10 * std::log10(std::max(1.0, geometry::distance(at, access_point)))};
}

double PathLoss::signal_dbm(const Point& at) const {
  return basis(at).dot(Eigen::Vector2d(at_1_m_dbm, exponent));
}

std::vector<Point> access_points_around(const std::vector<Point>& places) {
  Point low{infinity, infinity};
  Point high{-infinity, -infinity};
  for (const Point& place : places) {
    low = {std::min(low.x_m, place.x_m), std::min(low.y_m, place.y_m)};
    high = {std::max(high.x_m, place.x_m), std::max(high.y_m, place.y_m)};
  }
  const double step_m =
      std::max({lattice_m, (high.x_m - low.x_m) / steps, (high.y_m - low.y_m) / steps});
  std::vector<Point> points;
  for (double y_m = low.y_m - around_m; y_m <= high.y_m + around_m; y_m += step_m) {
    for (double x_m = low.x_m - around_m; x_m <= high.x_m + around_m; x_m += step_m) {
      points.push_back({x_m, y_m});
    }
  }
  return points;
}

PathLoss fit_path_loss(const std::vector<Point>& places, const Eigen::VectorXd& signals_dbm) {
  Fit best;
  for (const Point& access_point : access_points_around(places)) {
    const Fit fit = fit_at(access_point, places, signals_dbm);
    if (fit.cost < best.cost) best = fit;
  }
  return best.path_loss;
}

}  // namespace tocsin::link_map
