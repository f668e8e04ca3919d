// SPDX-License-Identifier: Apache-2.0
#include "decision/false_alarms.hpp"

#include <algorithm>
#include <boost/random/normal_distribution.hpp>
#include <random>

namespace tocsin::decision {
namespace {

class IndependentSource final : public QualitySource {
 public:
  IndependentSource(Normal law, std::uint64_t seed) : random_(seed), law_(law.mean, law.sd) {}
  double next() override { return std::clamp(law_(random_), 0.0, 100.0); }
  void restart() override {}

 private:
  std::mt19937_64 random_;
  boost::random::normal_distribution<double> law_;
};

constexpr double least_threshold = 1e-6;

}  // namespace

std::unique_ptr<QualitySource> independent(Normal law, std::uint64_t seed) {
  return std::make_unique<IndependentSource>(law, seed);
}

FalseAlarmCurve::FalseAlarmCurve(QualitySource& source, Detector& detector, const Effort& effort)
    : horizon_(effort.horizon) {
  for (int i = 0; i < effort.paths; ++i) {
    source.restart();
    detector.reset();
    Path records;
    double highest = 0;
    for (double n = 1; n <= horizon_; ++n) {
      const double level = detector.add(source.next());
      if (level <= highest) continue;
      highest = level;
      records.push_back({level, n});
    }
    highest_ = std::max(highest_, highest);
    paths_.push_back(std::move(records));
  }
}

const FalseAlarmCurve::Record* FalseAlarmCurve::crossing(const Path& path, double threshold) {
  const auto it = std::lower_bound(path.begin(), path.end(), threshold,
                                   [](const Record& r, double level) { return r.level < level; });
  return it == path.end() ? nullptr : &*it;
}

double FalseAlarmCurve::run_length(double threshold) const {
  double time = 0;
  double count = 0;
  for (const Path& path : paths_) {
    const Record* record = crossing(path, threshold);
    time += record != nullptr ? record->time : horizon_;
    count += record != nullptr;
  }
  return time / std::max(count, 0.5);
}

int FalseAlarmCurve::alarms(double threshold) const {
  return static_cast<int>(std::count_if(paths_.begin(), paths_.end(), [&](const Path& path) {
    return crossing(path, threshold) != nullptr;
  }));
}

std::optional<double> FalseAlarmCurve::threshold_for(double samples) const {
  if (run_length(least_threshold) > samples) return std::nullopt;
  double low = least_threshold;
  double high = highest_ * (1 + 1e-9) + least_threshold;
  while (high - low > 1e-9 * high) {
    const double middle = (low + high) / 2;
    (run_length(middle) < samples ? low : high) = middle;
  }
  return high;
}

}  // namespace tocsin::decision
