// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "foundation/numbers.hpp"
#include "geometry/pose.hpp"
#include "link_map/path_loss.hpp"

namespace tocsin::link_map {

/// Signal at a place, and what it was good for.
struct Reading {
  geometry::Point at;       ///< [m] frame map
  double signal_dbm = 0;    ///< [range -120,0]
  double lost_share = nan;  ///< of the packets [range 0,1] [invalid NaN: not measured]
};

/// Readings in a square of `LinkMap::place_m`, together.
struct Place {
  geometry::Point at;     ///< mean of where they were made
  double signal_dbm = 0;  ///< mean of the middle half of the last readings, at most 64
  int readings = 0;
};

/// What shadowing does: a field of covariance a exp(-d / b), and noise that is new at each place.
struct Field {
  double variance_db2 = 20;  ///< a
  double range_m = 2;        ///< b
  double noise_db2 = 9;
  double walls_db2 = 144;  ///< of the slow part, which no first room can teach
};

/// What signal a place has.
struct Prediction {
  double mean_dbm = 0;
  double deviation_db = 0;  ///< of what would be measured there, noise included
};

/// A map of the signal, learned from where it was measured: path loss, and shadowing as a Gaussian
/// process with an exponential covariance (universal kriging). Where the access point may be is
/// weighed by likelihood, and predictions are those of all such places together, so that they are
/// unsure where these differ. The field's parameters are those of the greatest likelihood; how far
/// it may be trusted where nobody has been is learned by leaving out one stretch of the way after
/// the other.
///
/// Pure. The mean of readings nearer to each other than `place_m` counts as one: its memory grows
/// with the floor that was seen, not with time.
class LinkMap {
 public:
  static constexpr double place_m = 0.3;
  static constexpr std::size_t most_places = 1200;  ///< that are used; of more, evenly chosen ones

  /// Places in the order in which they were first met, each near no other. Values that are not
  /// finite, or outside of [-120, 0] dBm, are left out.
  [[nodiscard]] static std::vector<Place> places_of(const std::vector<Reading>& readings);

  /// Learns from places in the order of the way. At least `least_places` are needed.
  explicit LinkMap(const std::vector<Place>& places);
  static constexpr std::size_t least_places = 8;

  [[nodiscard]] Prediction predict(const geometry::Point& at) const;
  /// The likeliest.
  [[nodiscard]] const PathLoss& path_loss() const { return trends_.front().path_loss; }
  [[nodiscard]] const Field& field() const { return field_; }
  /// By how much deviations grow where nothing was measured nearby.
  [[nodiscard]] double far_factor() const { return far_factor_; }

 private:
  /// One place of the access point, and what follows from it.
  struct Trend {
    PathLoss path_loss;
    Eigen::Matrix2d covariance;  ///< of K and n
    Eigen::MatrixXd basis;       ///< at the places,
    Eigen::MatrixXd solved;      ///< covariance^-1 of the field times it,
    Eigen::VectorXd weights;     ///< and times the residual of the path loss
    double log_likelihood = 0;
    double share = 0;  ///< of belief
  };
  LinkMap(std::vector<Place> places, const Field& field, double far_factor);
  void condition();
  [[nodiscard]] Trend trend_at(const geometry::Point& access_point,
                               const Eigen::VectorXd& solved_signals) const;
  void weigh_trends();
  [[nodiscard]] double likelihood(const Field& field, const Eigen::VectorXd& residual) const;
  void learn_field();
  void learn_far_factor();

  std::vector<Place> places_;
  Field field_;
  double far_factor_ = 1;
  Eigen::VectorXd signals_;
  Eigen::LLT<Eigen::MatrixXd> factor_;  ///< of the covariance of the places
  std::vector<Trend> trends_;           ///< the likeliest first
};

}  // namespace tocsin::link_map
