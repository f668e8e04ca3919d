// SPDX-License-Identifier: Apache-2.0
#include "localisation/localiser.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "foundation/numbers.hpp"

namespace tocsin::localisation {
namespace {

constexpr std::size_t most_hypotheses = 40;
constexpr std::size_t matched_hits = 120;
constexpr std::size_t weighed_beams = 45;
constexpr double wall_m = 0.12;      // a hit so near to a wall is of the wall
constexpr double through_m = 0.3;    // so far behind a wall no beam ends
constexpr double witnesses = 8;      // that the beams of a scan count for
constexpr double fading = 0.95;      // of evidence, each time some is counted
constexpr double counts_at = 0.1;    // of `moved_`
constexpr double hopeless = 20;      // less evidence than the best by so much
constexpr double decided = 12;       // more evidence than any other, to become sure
constexpr double carried_off = 0.3;  // less of a scan lies where the one before had something
constexpr double sure = 0.995;       // weight of a hypothesis that is alone
constexpr double same_m = 0.25;
constexpr double same_rad = 15 * degree;
constexpr int scans_to_lose = 8;
constexpr double way_before_trust_m = 1.5;
constexpr int searches_before_trust = 3;
constexpr double search_every = 0.3;  // of `since_search_`
constexpr int scans_to_search = 5;
constexpr double most_through = 0.1;  // of the beams of a pose that is right
constexpr double well_explained = 0.75;
constexpr std::size_t searched_candidates = 200;
constexpr int headings_a_scan = 8;
constexpr std::size_t candidates_a_scan = 34;
constexpr double smoothing = 0.2;
constexpr double most_step_m = 1.5;  // of odometry from scan to scan

// Logarithms of what a beam says of a pose.
constexpr double ends_at_wall = -0.3;
constexpr double ends_early = -1.9;
constexpr double goes_through = -3.9;

geometry::Pose inverse(const geometry::Pose& pose) {
  const double c = std::cos(pose.heading_rad);
  const double s = std::sin(pose.heading_rad);
  return {-c * pose.x_m - s * pose.y_m, s * pose.x_m - c * pose.y_m, -pose.heading_rad};
}

/// Of evenly spaced members of a list, at most so many.
template <class T>
std::vector<T> some_of(const std::vector<T>& all, std::size_t most) {
  if (all.size() <= most) return all;
  std::vector<T> some;
  for (std::size_t i = 0; i < most; ++i) some.push_back(all[i * all.size() / most]);
  return some;
}

double apart(const geometry::Pose& a, const geometry::Pose& b) {
  return std::max(distance(position(a), position(b)) / same_m,
                  std::abs(geometry::wrap_angle(a.heading_rad - b.heading_rad)) / same_rad);
}

}  // namespace

Localiser::Localiser(navigation::OccupancyMap map, const LocaliserParams& params)
    : map_(std::move(map)), distances_(map_), params_(params), search_(map_, distances_) {}

void Localiser::start_at(const geometry::Pose& pose, double deviation_m, double deviation_rad) {
  hypotheses_.clear();
  end_search();
  is_anywhere_ = false;
  badly_explained_ = 0;
  since_jump_m_ = way_before_trust_m;
  searches_ = searches_before_trust;
  was_tracked_ = true;
  usual_ = 0.7;
  Belief belief;
  belief.pose = pose;
  belief.covariance = Eigen::Vector3d(deviation_m * deviation_m, deviation_m * deviation_m,
                                      deviation_rad * deviation_rad)
                          .asDiagonal();
  add(belief, 0, {1, 0, 0});
  hypotheses_.front().is_fresh = true;
}

void Localiser::start_anywhere() {
  hypotheses_.clear();
  end_search();
  is_anywhere_ = true;
  was_tracked_ = false;
  since_jump_m_ = 0;
  searches_ = 0;
  usual_ = 0.6;
}

std::optional<Localiser::Estimate> Localiser::update(const laser::Scan& scan,
                                                     const geometry::Pose& odom) {
  if (!is_finite(odom)) return std::nullopt;
  move(scan.hits, odom);
  if ((hypotheses_.empty() && !is_anywhere_) || scan.hits.empty()) return std::nullopt;
  const bool is_old = last_scan_ && laser::is_repeated(*last_scan_, scan);
  last_scan_ = scan;
  if (is_old) return std::nullopt;
  const laser::Points hits = some_of(scan.hits, matched_hits);
  for (Hypothesis& hypothesis : hypotheses_) settle(hypothesis, hits);
  weigh(scan);
  ++scans_since_search_;
  search(scan, hits);
  prune();
  if (hypotheses_.empty()) return std::nullopt;
  return estimate();
}

/// The vehicle stands elsewhere at once: where it was is a guess like others.
void Localiser::doubt() {
  if (hypotheses_.empty()) return;
  hypotheses_.resize(1);
  end_search();
  hypotheses_.front().evidence = 0;
  was_tracked_ = false;
  searches_ = 0;
  since_jump_m_ = 0;
  since_search_ = 2 * search_every;
}

/// Odometry has begun anew: the vehicle is about where it was.
void Localiser::stay() {
  for (Hypothesis& hypothesis : hypotheses_) {
    hypothesis.belief.covariance.diagonal() += Eigen::Vector3d(0.1, 0.1, 0.1);
  }
}

void Localiser::move(const laser::Points& hits, const geometry::Pose& odom) {
  const geometry::Pose by_wheels = odom_ ? compose(inverse(*odom_), odom) : geometry::Pose{};
  odom_ = odom;
  if (std::hypot(by_wheels.x_m, by_wheels.y_m) > most_step_m) {
    motion_.begin_anew();
    return stay();
  }
  const auto [step, covariance, seen_before] = motion_.on_scan(hits, by_wheels);
  if (seen_before < carried_off) doubt();
  const double way_m = std::hypot(step.x_m, step.y_m);
  const double turn_rad = std::abs(geometry::wrap_angle(step.heading_rad));
  const double moved = way_m + turn_rad / 2;
  moved_ += moved;
  since_search_ += moved;
  since_jump_m_ += way_m;
  const double along_m = params_.odometry_share * way_m + 0.002;
  const double turned_rad = params_.odometry_turn_share * turn_rad + 0.03 * way_m + 0.002;
  for (Hypothesis& hypothesis : hypotheses_) {
    Belief& belief = hypothesis.belief;
    const double c = std::cos(belief.pose.heading_rad);
    const double s = std::sin(belief.pose.heading_rad);
    Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
    turn(0, 2) = -s * step.x_m - c * step.y_m;
    turn(1, 2) = c * step.x_m - s * step.y_m;
    belief.covariance = turn * belief.covariance * turn.transpose();
    belief.covariance.diagonal() +=
        Eigen::Vector3d(along_m * along_m, along_m * along_m, turned_rad * turned_rad);
    if (covariance) belief.covariance.diagonal() += covariance->diagonal();
    belief.pose = compose(belief.pose, step);
  }
  moved_since_search_ = compose(moved_since_search_, step);
}

/// Where odometry does not fit (a wheel has slipped), the scan alone may.
void Localiser::settle(Hypothesis& hypothesis, const laser::Points& hits) {
  const auto near_walls = [&](const geometry::Pose& pose) {
    double count = 0;
    for (const geometry::Point& hit : laser::transformed(hits, pose)) {
      if (distances_.nearest_m(hit) < wall_m) ++count;
    }
    return count / static_cast<double>(hits.size());
  };
  const Belief matched = match(distances_, hits, hypothesis.belief);
  const double share = near_walls(matched.pose);
  if (share < hypothesis.explained - 0.15) {
    Belief loose = hypothesis.belief;
    loose.covariance.diagonal() += Eigen::Vector3d(0.04, 0.04, 0.04);
    const Belief freed = match(distances_, hits, loose);
    if (near_walls(freed.pose) > share + 0.1) {
      hypothesis.belief = freed;
      return;
    }
  }
  hypothesis.belief = matched;
}

Localiser::Evidence Localiser::evidence_of(const laser::Scan& scan,
                                           const geometry::Pose& pose) const {
  const laser::Points from = laser::transformed({scan.laser}, pose);
  const laser::Points hits = laser::transformed(some_of(scan.hits, weighed_beams), pose);
  Evidence evidence;
  for (const geometry::Point& hit : hits) {
    if (distances_.nearest_m(hit) < wall_m) {
      evidence.explained += 1;
      evidence.log_likelihood += ends_at_wall;
      continue;
    }
    const double range_m = distance(from.front(), hit);
    const auto wall_at_m = map_.raycast(from.front(), bearing(from.front(), hit), range_m);
    const bool is_through = wall_at_m && *wall_at_m + through_m < range_m;
    evidence.through += is_through ? 1 : 0;
    evidence.log_likelihood += is_through ? goes_through : ends_early;
  }
  const auto count = static_cast<double>(hits.size());
  return {evidence.explained / count, evidence.through / count, evidence.log_likelihood / count};
}

void Localiser::weigh(const laser::Scan& scan) {
  const bool counts = moved_ >= counts_at;
  if (counts) moved_ = 0;
  for (Hypothesis& hypothesis : hypotheses_) {
    const Evidence evidence = evidence_of(scan, hypothesis.belief.pose);
    const double share = std::exchange(hypothesis.is_fresh, false) ? 1 : smoothing;
    hypothesis.explained += share * (evidence.explained - hypothesis.explained);
    hypothesis.through += share * (evidence.through - hypothesis.through);
    if (!counts) continue;
    hypothesis.evidence = fading * hypothesis.evidence + witnesses * evidence.log_likelihood;
  }
}

/// Where there is no guess at all, everything at once; else a part with each scan.
void Localiser::search(const laser::Scan& scan, const laser::Points& hits) {
  const bool is_idle = !search_.is_running() && candidates_.empty();
  if (is_idle && !wants_search()) return;
  if (is_idle) begin_search(hits);
  const bool is_first = hypotheses_.empty();
  if (search_.is_running()) {
    search_.work(is_first ? GlobalSearch::headings : headings_a_scan);
    if (search_.is_running()) return;
    candidates_ = search_.best(searched_candidates);
    std::reverse(candidates_.begin(), candidates_.end());
    if (!is_first) return;
  }
  try_candidates(scan, hits, is_first ? searched_candidates : candidates_a_scan);
  if (candidates_.empty()) ++searches_;
}

void Localiser::begin_search(const laser::Points& hits) {
  search_.begin(hits);
  moved_since_search_ = {};
  since_search_ = 0;
  scans_since_search_ = 0;
  is_anywhere_ = false;
}

void Localiser::end_search() {
  search_.end();
  candidates_.clear();
}

/// New hypotheses begin with what this scan says of them beside the likeliest one, as if it had
/// been seen five times; behind it when it was sure, and the more, the oftener they were not found
/// before.
void Localiser::try_candidates(const laser::Scan& scan, const laser::Points& hits,
                               std::size_t most) {
  constexpr double as_often = 5;
  constexpr double behind = 8;
  const double late = std::min(behind, 2.0 * searches_);
  const bool is_first = hypotheses_.empty();
  const double best = is_first ? 0 : hypotheses_.front().evidence;
  const double best_says =
      is_first ? 0 : evidence_of(scan, hypotheses_.front().belief.pose).log_likelihood;
  for (; most > 0 && !candidates_.empty(); --most, candidates_.pop_back()) {
    Belief belief;
    belief.pose = compose(candidates_.back(), moved_since_search_);
    belief.covariance = Eigen::Vector3d(0.04, 0.04, 0.02).asDiagonal();
    belief = match(distances_, hits, belief);
    const Evidence evidence = evidence_of(scan, belief.pose);
    const double more = as_often * witnesses * (evidence.log_likelihood - best_says);
    add(belief, best + (was_tracked_ ? std::min(more, 0.0) - behind : more - late), evidence);
  }
}

/// Until it is sure, and when the map explains less than it usually does.
bool Localiser::wants_search() const {
  if (hypotheses_.empty()) return is_anywhere_;
  const Hypothesis& best = hypotheses_.front();
  const bool doubts = best.explained < usual_ - 0.15 || best.through > most_through;
  if (was_tracked_ && !doubts) return false;
  return since_search_ > search_every || scans_since_search_ > scans_to_search;
}

void Localiser::add(const Belief& belief, double evidence, const Evidence& seen) {
  for (const Hypothesis& known : hypotheses_) {
    if (apart(known.belief.pose, belief.pose) < 1) return;
  }
  hypotheses_.push_back({belief, evidence, seen.explained, seen.through, 0, false});
}

void Localiser::prune() {
  if (hypotheses_.empty()) return;
  const geometry::Pose before = hypotheses_.front().belief.pose;
  std::stable_sort(hypotheses_.begin(), hypotheses_.end(),
                   [](const auto& a, const auto& b) { return a.evidence > b.evidence; });
  std::vector<Hypothesis> kept;
  for (const Hypothesis& one : hypotheses_) {
    const bool is_hopeless = one.evidence < hypotheses_.front().evidence - hopeless;
    const bool is_known = std::any_of(kept.begin(), kept.end(), [&](const Hypothesis& other) {
      return apart(one.belief.pose, other.belief.pose) < 1;
    });
    if (!is_hopeless && !is_known && kept.size() < most_hypotheses) kept.push_back(one);
  }
  hypotheses_ = std::move(kept);
  if (apart(before, hypotheses_.front().belief.pose) > 1) {
    since_jump_m_ = 0;
    searches_ = std::min(searches_, 1);
    was_tracked_ = false;
  }
  double sum = 0;
  for (Hypothesis& one : hypotheses_) {
    one.weight = std::exp(one.evidence - hypotheses_.front().evidence);
    sum += one.weight;
  }
  for (Hypothesis& one : hypotheses_) one.weight /= sum;
}

Health Localiser::health_of_best() {
  const Hypothesis& best = hypotheses_.front();
  badly_explained_ = best.explained < params_.lost_below ? badly_explained_ + 1 : 0;
  if (badly_explained_ >= scans_to_lose) {
    was_tracked_ = false;
    searches_ = 0;
    return Health::lost;
  }
  // Who stands sees one place only: more searches, and a better fit.
  const bool has_moved = since_jump_m_ >= way_before_trust_m && searches_ >= searches_before_trust;
  const bool has_looked = searches_ >= 2 * searches_before_trust && best.explained > well_explained;
  const double lead = hypotheses_.size() < 2 ? infinity : best.evidence - hypotheses_[1].evidence;
  const bool leads = was_tracked_ ? best.weight > sure : lead > decided;
  const bool is_alone = leads && (has_moved || has_looked);
  const bool fits = best.explained > std::max(params_.lost_below + 0.05, usual_ - 0.2) &&
                    best.through < most_through;
  was_tracked_ = is_alone && fits;
  if (was_tracked_) usual_ += 0.01 * (best.explained - usual_);
  return was_tracked_ ? Health::tracked : Health::uncertain;
}

Localiser::Estimate Localiser::estimate() {
  Estimate estimate;
  const Hypothesis& best = hypotheses_.front();
  estimate.belief = best.belief;
  estimate.explained = best.explained;
  estimate.health = health_of_best();
  for (const Hypothesis& other : hypotheses_) {
    const Eigen::Vector3d off(
        other.belief.pose.x_m - best.belief.pose.x_m, other.belief.pose.y_m - best.belief.pose.y_m,
        geometry::wrap_angle(other.belief.pose.heading_rad - best.belief.pose.heading_rad));
    if (&other != &best) estimate.belief.covariance += other.weight * off * off.transpose();
  }
  if (estimate.health == Health::uncertain) {
    estimate.belief.covariance.diagonal() += Eigen::Vector3d(1, 1, 0.3);
  }
  if (estimate.health == Health::lost) {
    estimate.belief.covariance.diagonal() += Eigen::Vector3d(25, 25, 3);
  }
  return estimate;
}

}  // namespace tocsin::localisation
