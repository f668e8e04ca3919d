// SPDX-License-Identifier: Apache-2.0
#include "localisation/localiser.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "foundation/numbers.hpp"
#include "foundation/some_of.hpp"

namespace tocsin::localisation {
namespace {

constexpr std::size_t most_hypotheses = 80;
constexpr std::size_t matched_hits = 120;
constexpr double counts_at = 0.1;   // of `moved_`
constexpr int scans_to_count = 10;  // where it stands,
constexpr int most_stood = 4;       // so often: a scan that is seen again says little new
constexpr double same_m = 0.25;
constexpr double same_rad = 15 * degree;
constexpr double smoothing = 0.2;
constexpr double most_step_m = 1.5;  // of odometry from scan to scan

// Evidence, logarithms.
constexpr double hopeless = 20;          // less than the best by so much
constexpr double decided = 12;           // more than any other, to become sure,
constexpr double decided_in_time = 6;    // and the same after it has led for a while,
constexpr double doubt_of_unknown = 25;  // and so much more where the map explains nothing
constexpr double stays_decided = 5;      // to remain sure
constexpr double follows = 2;            // the same while each scan shows what the last did
constexpr double advance = 8;            // of a start that somebody has told

// How much of a scan lies where the one before had something.
constexpr double followed_above = 0.7;
constexpr double comparable_above = 0.5;
constexpr double carried_off = 0.3;
constexpr int scans_to_be_elsewhere = 2;  // one may be of somebody who passes close by

// What the map explains.
constexpr double usual_at_first = 0.6;
constexpr double most_through = 0.1;  // of the beams of a pose that is right
constexpr double well_explained = 0.75;
constexpr double wholly_explained = 0.95;
constexpr double least_explained = 0.15;
constexpr double vague_m2 = 0.09;

constexpr int scans_to_lose = 8;
constexpr int scans_to_follow = 10;
constexpr double way_before_trust_m = 1.5;
constexpr double way_before_patience_m = 3;  // along a corridor evidence does not add up,
constexpr double way_of_patience_m = 3;      // but who is wrong does not lead for long
constexpr int searches_before_trust = 3;
constexpr double search_every = 0.5;  // of `since_search_`
constexpr double look_around_every = 0.5;
constexpr int scans_to_search = 10;
constexpr std::size_t searched_candidates = 200;
constexpr int headings_a_scan = 8;
constexpr std::size_t candidates_a_scan = 34;

double apart(const geometry::Pose& a, const geometry::Pose& b) {
  return std::max(distance(position(a), position(b)) / same_m,
                  std::abs(geometry::wrap_angle(a.heading_rad - b.heading_rad)) / same_rad);
}

}  // namespace

Localiser::Localiser(navigation::OccupancyMap map, const LocaliserParams& params)
    : map_(std::move(map)),
      distances_(map_),
      params_(params),
      beams_(map_, distances_),
      search_(map_, distances_) {}

void Localiser::start_at(const geometry::Pose& pose, double deviation_m, double deviation_rad) {
  hypotheses_.clear();
  end_search();
  is_anywhere_ = false;
  unfollow();
  badly_explained_ = 0;
  since_jump_m_ = way_before_trust_m;
  searches_ = searches_before_trust;
  is_told_ = true;
  was_tracked_ = true;
  usual_ = usual_at_first;
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
  unfollow();
  since_jump_m_ = 0;
  searches_ = 0;
  usual_ = usual_at_first;
  is_told_ = false;
  recent_.clear();
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
  recent_.clear();
  is_told_ = false;
  unfollow();
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
    recent_.clear();
    unfollow();
    return stay();
  }
  const auto [step, covariance, seen_before] = motion_.on_scan(hits, by_wheels);
  if (seen_before < followed_above) unfollow();
  if (seen_before < comparable_above) recent_.clear();
  unlike_scans_ = seen_before < carried_off ? unlike_scans_ + 1 : 0;
  if (unlike_scans_ == scans_to_be_elsewhere) doubt();
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
  recent_.move(step);
}

/// Where odometry does not fit (a wheel has slipped), the scan alone may.
void Localiser::settle(Hypothesis& hypothesis, const laser::Points& hits) {
  const Belief matched = match(distances_, hits, hypothesis.belief);
  const double share = beams_.explained(hits, matched.pose);
  if (share < hypothesis.explained - 0.15) {
    Belief loose = hypothesis.belief;
    loose.covariance.diagonal() += Eigen::Vector3d(0.04, 0.04, 0.04);
    const Belief freed = match(distances_, hits, loose);
    if (beams_.explained(hits, freed.pose) > share + 0.1) {
      hypothesis.belief = freed;
      return;
    }
  }
  hypothesis.belief = matched;
}

void Localiser::weigh(const laser::Scan& scan) {
  const bool has_moved = moved_ >= counts_at || recent_.empty();
  const bool has_stood = ++uncounted_ >= scans_to_count && stood_ < most_stood;
  const bool counts = has_moved || has_stood;
  if (counts) {
    stood_ = has_moved ? 0 : stood_ + 1;
    uncounted_ = 0;
    moved_ = 0;
    recent_.add(scan);
  }
  for (Hypothesis& hypothesis : hypotheses_) {
    const Evidence evidence = beams_.evidence_of(scan, hypothesis.belief.pose);
    const double share = std::exchange(hypothesis.is_fresh, false) ? 1 : smoothing;
    hypothesis.explained += share * (evidence.explained - hypothesis.explained);
    hypothesis.through += share * (evidence.through - hypothesis.through);
    if (!counts) continue;
    hypothesis.evidence = RecentScans::fading * hypothesis.evidence +
                          RecentScans::witnesses * evidence.log_likelihood;
  }
}

/// Where there is no guess at all, everything at once; else a part with each scan.
void Localiser::search(const laser::Scan& scan, const laser::Points& hits) {
  if (is_followed_ && since_search_ > look_around_every) return look_around(scan, hits);
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

/// Wheels that slip where the scans do not show it leave it somewhat before or behind the truth.
void Localiser::look_around(const laser::Scan& scan, const laser::Points& hits) {
  since_search_ = 0;
  moved_since_search_ = {};
  candidates_.clear();
  const geometry::Pose here = hypotheses_.front().belief.pose;
  for (const double away_m : {0.4, 0.8}) {
    for (int i = 0; i < 8; ++i) {
      candidates_.push_back({here.x_m + away_m * std::cos(i * pi / 4),
                             here.y_m + away_m * std::sin(i * pi / 4), here.heading_rad});
    }
  }
  try_candidates(scan, hits, candidates_.size());
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

/// A new hypothesis begins with the evidence that it would have if it had been known on the last
/// metres.
void Localiser::try_candidates(const laser::Scan& scan, const laser::Points& hits,
                               std::size_t most) {
  std::optional<geometry::Pose> best;
  if (!hypotheses_.empty()) best = hypotheses_.front().belief.pose;
  const double told = is_told_ || is_followed_ ? advance : 0;
  const double from = (best ? hypotheses_.front().evidence : 0) - told;
  for (; most > 0 && !candidates_.empty(); --most, candidates_.pop_back()) {
    Belief belief;
    belief.pose = compose(candidates_.back(), moved_since_search_);
    belief.covariance = Eigen::Vector3d(0.04, 0.04, 0.02).asDiagonal();
    belief = match(distances_, hits, belief);
    const double least = best ? -2 * hopeless : -infinity;
    const double more = recent_.advantage(beams_, belief.pose, best, least);
    add(belief, from + more, beams_.evidence_of(scan, belief.pose));
  }
}

/// Until it is sure, and when the map explains less than it usually does.
bool Localiser::wants_search() const {
  if (hypotheses_.empty()) return is_anywhere_;
  const Hypothesis& best = hypotheses_.front();
  if (is_followed_) return false;
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

void Localiser::unfollow() {
  is_followed_ = false;
  sure_scans_ = 0;
}

/// Another hypothesis has become the likeliest.
void Localiser::jump(const geometry::Pose& from) {
  unfollow();
  if (distance(position(from), position(hypotheses_.front().belief.pose)) < 1) return;
  since_jump_m_ = 0;
  searches_ = std::min(searches_, 1);
  was_tracked_ = false;
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
  if (apart(before, hypotheses_.front().belief.pose) > 1) jump(before);
  double sum = 0;
  for (Hypothesis& one : hypotheses_) {
    one.weight = std::exp(one.evidence - hypotheses_.front().evidence);
    sum += one.weight;
  }
  for (Hypothesis& one : hypotheses_) one.weight /= sum;
}

/// Of the likeliest hypothesis over others that lie apart; those beside it are in its covariance.
double Localiser::lead_of_best() const {
  const Hypothesis& best = hypotheses_.front();
  const auto rival = std::find_if(hypotheses_.begin() + 1, hypotheses_.end(), [&](const auto& one) {
    return apart(one.belief.pose, best.belief.pose) > 2;
  });
  return rival == hypotheses_.end() ? infinity : best.evidence - rival->evidence;
}

/// Whether it stays sure though the map explains little: each scan shows what the one before did,
/// and boxes that no map shows contradict nothing.
bool Localiser::stays_followed() const {
  const Hypothesis& best = hypotheses_.front();
  return is_followed_ && lead_of_best() > follows && best.through < most_through &&
         best.explained > std::max(least_explained, usual_ - 0.3) &&
         best.belief.covariance.topLeftCorner<2, 2>().trace() < vague_m2;
}

/// How far less evidence will do [range 0,1]: where the map explains everything, and the best has
/// led for a while.
double Localiser::patience() const {
  if (hypotheses_.front().explained < wholly_explained) return 0;
  return std::clamp((since_jump_m_ - way_before_patience_m) / way_of_patience_m, 0.0, 1.0);
}

bool Localiser::is_sure() const {
  const Hypothesis& best = hypotheses_.front();
  // Who stands sees one place only: more searches, and a better fit.
  const bool has_moved = since_jump_m_ >= way_before_trust_m && searches_ >= searches_before_trust;
  const bool has_looked = searches_ >= 2 * searches_before_trust && best.explained > well_explained;
  const double to_become = decided + patience() * (decided_in_time - decided);
  const double wanted =
      was_tracked_ ? stays_decided : to_become + doubt_of_unknown * (1 - best.explained);
  const bool is_alone = lead_of_best() > wanted && (has_moved || has_looked);
  const bool fits = best.explained > std::max(params_.lost_below + 0.05, usual_ - 0.2) &&
                    best.through < most_through;
  return is_alone && fits;
}

Health Localiser::health_of_best() {
  const Hypothesis& best = hypotheses_.front();
  is_followed_ = stays_followed();
  if (!is_followed_) {
    badly_explained_ = best.explained < params_.lost_below ? badly_explained_ + 1 : 0;
    if (badly_explained_ >= scans_to_lose) {
      was_tracked_ = false;
      searches_ = 0;
      return Health::lost;
    }
    was_tracked_ = is_sure();
    sure_scans_ = was_tracked_ ? sure_scans_ + 1 : 0;
    is_followed_ = sure_scans_ >= scans_to_follow;
  }
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
