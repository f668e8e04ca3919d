// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "decision/run_length.hpp"
#include "foundation/error.hpp"

namespace tocsin::decision {
namespace {

constexpr int path_count = 200;

/// The samples at which one path's W first exceeds each of its earlier levels.
struct Record {
  double level;
  double time;
};
using Path = std::vector<Record>;

class Resampler {
 public:
  Resampler(const std::vector<double>& ratios, int block, unsigned seed)
      : ratios_(ratios), block_(block), random_(seed), start_(0, ratios.size() - 1) {}

  double next() {
    if (left_ == 0) {
      at_ = start_(random_);
      left_ = block_;
    }
    --left_;
    const double l = ratios_[at_];
    at_ = at_ + 1 == ratios_.size() ? 0 : at_ + 1;
    return l;
  }
  void cut() { left_ = 0; }

 private:
  const std::vector<double>& ratios_;
  int block_;
  std::mt19937_64 random_;
  std::uniform_int_distribution<std::size_t> start_;
  std::size_t at_ = 0;
  int left_ = 0;
};

Path run(Resampler& source, double horizon) {
  source.cut();
  Path records;
  Cusum cusum;
  for (double n = 1; n <= horizon; ++n) {
    const double w = cusum.add(source.next());
    if (w > (records.empty() ? 0 : records.back().level)) records.push_back({w, n});
  }
  return records;
}

struct Crossings {
  double time = 0;
  double count = 0;
};

/// Time at risk and number of paths that reach alpha within the horizon.
Crossings crossings(const std::vector<Path>& paths, double alpha, double horizon) {
  Crossings sum;
  for (const Path& path : paths) {
    const auto it = std::lower_bound(path.begin(), path.end(), alpha,
                                     [](const Record& r, double a) { return r.level < a; });
    sum.count += it != path.end();
    sum.time += it != path.end() ? it->time : horizon;
  }
  return sum;
}

double run_length(const Crossings& c) { return c.time / std::max(c.count, 0.5); }

void check(const std::vector<double>& ratios, int block) {
  for (const double l : ratios) {
    if (std::isnan(l)) throw ConfigError("calibration: a ratio is NaN, must be a number");
  }
  if (block >= 1 && ratios.size() >= 2 * static_cast<std::size_t>(block)) return;
  std::ostringstream text;
  text << "calibration: " << ratios.size() << " samples are less than 2 blocks of " << block;
  throw ConfigError(text.str());
}

}  // namespace

Calibration calibrate_alpha(const std::vector<double>& ratios, int block, double samples,
                            unsigned seed) {
  check(ratios, block);
  const double horizon = 4 * samples;
  Resampler source(ratios, block, seed);
  std::vector<Path> paths;
  for (int i = 0; i < path_count; ++i) paths.push_back(run(source, horizon));
  double low = 1e-6;
  double high = low;
  for (const Path& path : paths) high = std::max(high, path.empty() ? 0 : path.back().level);
  const double least = run_length(crossings(paths, low, horizon));
  if (least > samples) return {low, least, 1, true};
  while (high - low > 1e-9 * high) {
    const double middle = (low + high) / 2;
    (run_length(crossings(paths, middle, horizon)) < samples ? low : high) = middle;
  }
  const Crossings c = crossings(paths, high, horizon);
  return {high, run_length(c), 1 / std::sqrt(std::max(c.count, 1.0)), false};
}

}  // namespace tocsin::decision
