// SPDX-License-Identifier: Apache-2.0
#include "decision/false_alarms.hpp"

#include <algorithm>
#include <boost/random/normal_distribution.hpp>
#include <random>

namespace tocsin::decision {
namespace {

class IndependentSource final : public QualitySource {
 public:
  IndependentSource(const Density& law, std::uint64_t seed) : random_(seed) {
    for (int i = 0; i <= cells; ++i) cdf_.push_back(law.cdf(100.0 * i / cells));
  }
  double next() override {
    const double u = uniform_(random_);
    const auto above = std::upper_bound(cdf_.begin(), cdf_.end(), u);
    if (above == cdf_.begin()) return 0;
    if (above == cdf_.end()) return 100;
    const double share = (u - *(above - 1)) / (*above - *(above - 1));
    return (static_cast<double>(above - cdf_.begin()) - 1 + share) * 100 / cells;
  }
  void restart() override {}

 private:
  static constexpr int cells = 4000;
  std::vector<double> cdf_;
  std::mt19937_64 random_;
  std::uniform_real_distribution<double> uniform_{0, 1};
};

class IndependentNormalSource final : public QualitySource {
 public:
  IndependentNormalSource(double mean, double sd, std::uint64_t seed)
      : random_(seed), law_(mean, sd) {}
  double next() override { return std::clamp(law_(random_), 0.0, 100.0); }
  void restart() override {}

 private:
  std::mt19937_64 random_;
  boost::random::normal_distribution<double> law_;
};

constexpr double least_threshold = 1e-6;

}  // namespace

std::unique_ptr<QualitySource> independent(const Density& law, std::uint64_t seed) {
  if (law.family() != Family::normal) return std::make_unique<IndependentSource>(law, seed);
  return std::make_unique<IndependentNormalSource>(law.parameters()[0], law.parameters()[1], seed);
}

FalseAlarmCurve::FalseAlarmCurve(QualitySource& source, const Detector& detector,
                                 const Effort& effort)
    : horizon_(effort.horizon) {
  for (int i = 0; i < effort.paths; ++i) {
    source.restart();
    Detector running = detector;
    Path records;
    double highest = 0;
    for (double n = 1; n <= horizon_; ++n) {
      const double level = running.add(source.next());
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
