// SPDX-License-Identifier: Apache-2.0
#include "decision/joint_index.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "foundation/error.hpp"
#include "foundation/numbers.hpp"

namespace tocsin::decision {
namespace {

constexpr double good_mean = 80;
constexpr double good_sd = 10;
constexpr double bound = 6;  // of a score, in standard deviations
constexpr std::size_t pairs = joint_readings * (joint_readings - 1) / 2;

using Vector = std::array<double, joint_readings>;
using Correlations = std::array<Vector, joint_readings>;

double share_score(const std::optional<double>& percent) {
  return percent ? std::asin(std::sqrt(std::clamp(*percent / 100, 0.0, 1.0))) : nan;
}

void check_length(const char* name, std::size_t length, std::size_t wanted) {
  if (length == wanted) return;
  std::ostringstream text;
  text << "quality." << name << ": " << length << " numbers, must be " << wanted;
  throw ConfigError(text.str());
}

Correlations correlations_of(const std::vector<double>& upper) {
  Correlations matrix{};
  std::size_t at = 0;
  for (std::size_t i = 0; i < joint_readings; ++i) {
    matrix[i][i] = 1;
    for (std::size_t j = i + 1; j < joint_readings; ++j) {
      matrix[i][j] = matrix[j][i] = upper[at++];
    }
  }
  return matrix;
}

bool has(std::size_t set, std::size_t reading) { return (set >> reading & 1U) != 0; }

/// The readings that are not in `set` stand alone and do not fall.
void restrict_to(std::size_t set, Correlations& r, Vector& fall) {
  for (std::size_t k = 0; k < joint_readings; ++k) {
    if (has(set, k)) continue;
    for (std::size_t j = 0; j < joint_readings; ++j) r[k][j] = r[j][k] = 0;
    r[k][k] = 1;
    fall[k] = 0;
  }
}

/// Solves R w = fall for the readings in `set`, 0 for all others, by elimination; false when R is
/// not positive definite there.
bool solve(Correlations r, Vector fall, std::size_t set, Vector& w) {
  restrict_to(set, r, fall);
  for (std::size_t k = 0; k < joint_readings; ++k) {
    if (r[k][k] < 1e-6) return false;
    for (std::size_t i = k + 1; i < joint_readings; ++i) {
      const double factor = r[i][k] / r[k][k];
      for (std::size_t j = k; j < joint_readings; ++j) r[i][j] -= factor * r[k][j];
      fall[i] -= factor * fall[k];
    }
  }
  for (std::size_t k = joint_readings; k-- > 0;) {
    w[k] = fall[k];
    for (std::size_t j = k + 1; j < joint_readings; ++j) w[k] -= r[k][j] * w[j];
    w[k] /= r[k][k];
  }
  return true;
}

/// The weights of the readings in `set`, of which none is negative.
bool weigh(const Correlations& r, const Vector& fall, std::size_t set, Vector& w) {
  while (solve(r, fall, set, w)) {
    const auto least = std::min_element(w.begin(), w.end());
    if (*least >= 0) return true;
    set &= ~(std::size_t{1} << static_cast<std::size_t>(least - w.begin()));
  }
  return false;
}

double product(const Vector& a, const Vector& b) {
  double sum = 0;
  for (std::size_t i = 0; i < joint_readings; ++i) sum += a[i] * b[i];
  return sum;
}

double norm(const Correlations& r, const Vector& w) {
  double sum = 0;
  for (std::size_t i = 0; i < joint_readings; ++i) {
    for (std::size_t j = 0; j < joint_readings; ++j) sum += w[i] * r[i][j] * w[j];
  }
  return std::sqrt(sum);
}

/// The weights for a projection of unit variance; all 0 when none of these readings falls.
Vector unit_weights(const Correlations& r, const Vector& fall, std::size_t set) {
  Vector w{};
  if (!weigh(r, fall, set, w)) {
    throw ConfigError(
        "quality.joint_correlation: is not that of any readings (not positive definite)");
  }
  const double length = norm(r, w);
  for (double& weight : w) weight = length > 0 ? weight / length : 0;
  return w;
}

}  // namespace

std::array<double, joint_readings> joint_scores(const JointIndexInput& input) {
  const auto rtt = input.rtt_ms;
  return {share_score(input.per_percent), rtt ? std::log1p(std::max(0.0, *rtt)) : nan,
          share_score(input.retry_percent), share_score(input.busy_percent),
          input.signal_dbm ? -*input.signal_dbm : nan};
}

JointIndex::JointIndex(const JointIndexParams& params) {
  check_length("joint_center", params.joint_center.size(), joint_readings);
  check_length("joint_scale", params.joint_scale.size(), joint_readings);
  check_length("joint_correlation", params.joint_correlation.size(), pairs);
  const std::size_t kinds = std::max<std::size_t>(1, params.joint_fall.size() / joint_readings);
  check_length("joint_fall", params.joint_fall.size(), kinds * joint_readings);
  std::copy(params.joint_center.begin(), params.joint_center.end(), center_.begin());
  std::copy(params.joint_scale.begin(), params.joint_scale.end(), scale_.begin());
  const Correlations r = correlations_of(params.joint_correlation);
  for (std::size_t kind = 0; kind < kinds; ++kind) {
    Vector fall{};
    std::copy_n(params.joint_fall.begin() + static_cast<std::ptrdiff_t>(kind * joint_readings),
                joint_readings, fall.begin());
    Direction direction;
    for (std::size_t set = 1; set < subsets; ++set) {
      const Vector w = unit_weights(r, fall, set);
      direction.weights[set] = w;
      direction.distance[set] = product(w, fall);
    }
    if (!(direction.distance.back() > 0)) {
      throw ConfigError("quality.joint_fall: a kind of bad link in which no reading falls");
    }
    directions_.push_back(direction);
  }
}

double JointIndex::evaluate(const JointIndexInput& input) const {
  Vector z = joint_scores(input);
  std::size_t set = 0;
  for (std::size_t i = 0; i < joint_readings; ++i) {
    if (std::isnan(z[i])) {
      z[i] = 0;
      continue;
    }
    set |= std::size_t{1} << i;
    z[i] = std::clamp((z[i] - center_[i]) / scale_[i], -bound, bound);
  }
  double worst = nan;
  for (const Direction& direction : directions_) {
    if (!(direction.distance[set] > 0)) continue;
    const double quality = good_mean - good_sd * product(direction.weights[set], z);
    worst = std::isnan(worst) ? quality : std::min(worst, quality);
  }
  return std::isnan(worst) ? nan : std::clamp(worst, 0.0, 100.0);
}

double JointIndex::distance() const {
  double least = infinity;
  for (const Direction& direction : directions_) {
    least = std::min(least, direction.distance.back());
  }
  return least;
}

}  // namespace tocsin::decision
