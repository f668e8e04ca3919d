// SPDX-License-Identifier: Apache-2.0
#include "link_map/link_map.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "foundation/numbers.hpp"
#include "foundation/some_of.hpp"
#include "link_map/survey.hpp"

namespace tocsin::link_map {
namespace {

using geometry::Point;

constexpr std::size_t learned_places = 350;  // for the field's parameters: the rest says the same
constexpr int stretches = 6;                 // that are left out, one after the other
constexpr double normal_95 = 1.96;
/// What walls do that nobody has driven behind yet: about two of them, 3.4 to 6.9 dB each (COST
/// 231), in the width of a room. Without it a first room teaches that nothing ever changes.
constexpr double walls_db2 = 144;
constexpr double walls_range_m = 5;
constexpr double usual_at_1_m_dbm = -40;  // and how far sites differ
constexpr double usual_at_1_m_db = 10;
constexpr double usual_exponents = 1;
constexpr double most_far_factor = 4;

Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

double covariance(const Field& field, double distance_m) {
  return field.variance_db2 * std::exp(-distance_m / field.range_m) +
         field.walls_db2 * std::exp(-distance_m / walls_range_m);
}

Eigen::MatrixXd covariance_of(const std::vector<Place>& places, const Field& field) {
  const Eigen::Index n = index(places.size());
  Eigen::MatrixXd matrix(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index k = 0; k <= i; ++k) {
      const double away_m = geometry::distance(places[static_cast<std::size_t>(i)].at,
                                               places[static_cast<std::size_t>(k)].at);
      matrix(i, k) = matrix(k, i) = covariance(field, away_m);
    }
    matrix(i, i) += field.noise_db2;
  }
  return matrix;
}

}  // namespace

std::vector<Place> LinkMap::places_of(const std::vector<Reading>& readings) {
  Survey survey;
  for (const Reading& reading : readings) (void)survey.add(reading);
  return survey.places();
}

LinkMap::LinkMap(const std::vector<Place>& places) : places_(some_of(places, most_places)) {
  assert(places_.size() >= least_places);
  learn_field();
  learn_far_factor();
}

LinkMap::LinkMap(std::vector<Place> places, const Field& field, double far_factor)
    : places_(std::move(places)), field_(field), far_factor_(far_factor) {
  condition();
}

void LinkMap::condition() {
  signals_.resize(index(places_.size()));
  std::vector<Point> at;
  for (const Place& place : places_) {
    signals_(index(at.size())) = place.signal_dbm;
    at.push_back(place.at);
  }
  factor_.compute(covariance_of(places_, field_));
  const Eigen::VectorXd solved_signals = factor_.solve(signals_);
  trends_.clear();
  for (const Point& access_point : access_points_around(at)) {
    trends_.push_back(trend_at(access_point, solved_signals));
  }
  weigh_trends();
}

/// K and n by generalised least squares, held near what is usual.
LinkMap::Trend LinkMap::trend_at(const Point& access_point,
                                 const Eigen::VectorXd& solved_signals) const {
  Trend trend;
  trend.path_loss.access_point = access_point;
  trend.basis.resize(signals_.size(), 2);
  for (Eigen::Index i = 0; i < signals_.size(); ++i) {
    trend.basis.row(i) = trend.path_loss.basis(places_[static_cast<std::size_t>(i)].at).transpose();
  }
  trend.solved = factor_.solve(trend.basis);
  const Eigen::Vector2d usual(usual_at_1_m_dbm, usual_exponent);
  const Eigen::Matrix2d hold = Eigen::Vector2d(1 / (usual_at_1_m_db * usual_at_1_m_db),
                                               1 / (usual_exponents * usual_exponents))
                                   .asDiagonal();
  const Eigen::Matrix2d information = trend.basis.transpose() * trend.solved + hold;
  trend.covariance = information.inverse();
  const Eigen::Vector2d found =
      trend.covariance * (trend.basis.transpose() * solved_signals + hold * usual);
  trend.path_loss.at_1_m_dbm = found(0);
  trend.path_loss.exponent = found(1);
  trend.weights = solved_signals - trend.solved * found;
  const double cost =
      signals_.dot(solved_signals) + usual.dot(hold * usual) - found.dot(information * found);
  trend.log_likelihood = -0.5 * cost - 0.5 * std::log(information.determinant());
  return trend;
}

/// Keeps those that are worth a thought.
void LinkMap::weigh_trends() {
  constexpr double unlikely = 7;  // logarithm, behind the likeliest
  constexpr std::size_t most_trends = 60;
  std::stable_sort(trends_.begin(), trends_.end(), [](const Trend& a, const Trend& b) {
    return a.log_likelihood > b.log_likelihood;
  });
  const double best = trends_.front().log_likelihood;
  trends_.erase(
      std::remove_if(trends_.begin(), trends_.end(),
                     [&](const Trend& one) { return one.log_likelihood < best - unlikely; }),
      trends_.end());
  if (trends_.size() > most_trends) trends_.resize(most_trends);
  double sum = 0;
  for (Trend& trend : trends_) sum += trend.share = std::exp(trend.log_likelihood - best);
  for (Trend& trend : trends_) trend.share /= sum;
}

Prediction LinkMap::predict(const Point& at) const {
  const Eigen::Index n = index(places_.size());
  Eigen::VectorXd to_places(n);
  double nearest_m = infinity;
  for (Eigen::Index i = 0; i < n; ++i) {
    const double away_m = geometry::distance(at, places_[static_cast<std::size_t>(i)].at);
    nearest_m = std::min(nearest_m, away_m);
    to_places(i) = covariance(field_, away_m);
  }
  const double known = to_places.dot(factor_.solve(to_places));
  const double field = std::max(0.0, covariance(field_, 0) - known) + field_.noise_db2;
  double mean = 0;
  double square = 0;
  for (const Trend& trend : trends_) {
    const Eigen::Vector2d basis = trend.path_loss.basis(at);
    const Eigen::Vector2d open = basis - trend.solved.transpose() * to_places;
    const double dbm = trend.path_loss.signal_dbm(at) + to_places.dot(trend.weights);
    mean += trend.share * dbm;
    square += trend.share * (dbm * dbm + open.dot(trend.covariance * open));
  }
  // Far away is what lies so far from all places that the field says nothing of it.
  const double far = 1 - std::exp(-std::max(0.0, nearest_m - place_m) / field_.range_m);
  const double factor = 1 + (far_factor_ - 1) * far;
  return {mean, factor * std::sqrt(field + std::max(0.0, square - mean * mean))};
}

/// Logarithm of the likelihood of a residual, its scale profiled out.
double LinkMap::likelihood(const Field& field, const Eigen::VectorXd& residual) const {
  const Eigen::LLT<Eigen::MatrixXd> factor(covariance_of(places_, field));
  const auto n = static_cast<double>(residual.size());
  const double scale = residual.dot(factor.solve(residual)) / n;
  const Eigen::MatrixXd& lower = factor.matrixLLT();
  return -0.5 * n * std::log(scale) - lower.diagonal().array().log().sum();
}

void LinkMap::learn_field() {
  const std::vector<Place> all = std::move(places_);
  places_ = some_of(all, learned_places);
  std::vector<Point> at;
  Eigen::VectorXd residual(index(places_.size()));
  for (const Place& place : places_) at.push_back(place.at);
  for (std::size_t i = 0; i < at.size(); ++i) residual(index(i)) = places_[i].signal_dbm;
  const PathLoss fitted = fit_path_loss(at, residual);
  for (std::size_t i = 0; i < at.size(); ++i) residual(index(i)) -= fitted.signal_dbm(at[i]);
  double best = -infinity;
  Field learned;
  for (const double range_m : {0.7, 1.0, 1.5, 2.0, 3.0, 4.5, 7.0, 10.0}) {
    for (const double share : {0.1, 0.3, 0.5, 0.65, 0.8, 0.9}) {
      const Field field{share, range_m, 1 - share, 0};
      const double value = likelihood(field, residual);
      if (value <= best) continue;
      best = value;
      learned = field;
    }
  }
  const Eigen::LLT<Eigen::MatrixXd> factor(covariance_of(places_, learned));
  constexpr double least_db2 = 1;
  const double scale = std::max(
      least_db2, residual.dot(factor.solve(residual)) / static_cast<double>(residual.size()));
  field_ = {learned.variance_db2 * scale, learned.range_m, learned.noise_db2 * scale, walls_db2};
  places_ = all;
  condition();
}

/// Each stretch of the way is predicted from the others, as if nobody had been there.
void LinkMap::learn_far_factor() {
  std::vector<double> misses;
  for (int stretch = 0; stretch < stretches; ++stretch) {
    const std::size_t begin = places_.size() * static_cast<std::size_t>(stretch) / stretches;
    const std::size_t end = places_.size() * static_cast<std::size_t>(stretch + 1) / stretches;
    std::vector<Place> others(places_.begin(),
                              places_.begin() + static_cast<std::ptrdiff_t>(begin));
    others.insert(others.end(), places_.begin() + static_cast<std::ptrdiff_t>(end), places_.end());
    if (others.size() < least_places) continue;
    const LinkMap without(some_of(others, learned_places), field_, 1);
    for (std::size_t i = begin; i < end; ++i) {
      const Prediction said = without.predict(places_[i].at);
      misses.push_back(std::abs(places_[i].signal_dbm - said.mean_dbm) / said.deviation_db);
    }
  }
  if (misses.empty()) return;
  std::sort(misses.begin(), misses.end());
  const std::size_t at = std::min(misses.size() - 1, misses.size() * 95 / 100);
  far_factor_ = std::clamp(misses[at] / normal_95, 1.0, most_far_factor);
}

}  // namespace tocsin::link_map
