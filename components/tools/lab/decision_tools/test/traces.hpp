// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <random>
#include <string>

#include "foundation/numbers.hpp"
#include "policy_settings.hpp"
#include "quality_trace.hpp"

namespace tocsin::tools {

inline QualityTrace normal_trace(double mean, double sd, int n) {
  std::mt19937_64 random(4);  // NOLINT: a fixed seed is the point
  std::normal_distribution<double> law(mean, sd);
  QualityTrace trace;
  trace.path = "x.csv";
  trace.kind = "test";
  for (int i = 0; i < n; ++i) {
    trace.time_s.push_back(i);
    trace.qni.push_back(std::clamp(law(random), 0.0, 100.0));
  }
  return trace;
}

inline PolicySettings with_policy(const std::string& name) {
  return load_settings({{}, "", {}, name});
}

/// Good, 40 bad samples from 50 on, good.
inline QualityTrace dip() {
  QualityTrace trace = normal_trace(80, 2, 150);
  trace.bad.assign(150, false);
  for (std::size_t i = 50; i < 90; ++i) {
    trace.qni[i] = 30;
    trace.bad[i] = true;
  }
  return trace;
}

/// A link that is good and bad by turns, some of its samples without measurement, one in twenty
/// after a break that is longer than any pause may be.
inline QualityTrace random_trace(unsigned seed, int samples) {
  std::mt19937_64 random(seed);
  const auto chance = [&random](unsigned one_in) { return random() % one_in == 0; };
  std::normal_distribution<double> noise(0, 8);
  QualityTrace trace;
  trace.path = "random.csv";
  double time_s = 0;
  bool bad = false;
  for (int i = 0; i < samples; ++i) {
    if (chance(bad ? 12 : 25)) bad = !bad;
    trace.time_s.push_back(time_s);
    trace.bad.push_back(bad);
    const double quality = (bad ? 36 : 82) + noise(random);
    trace.qni.push_back(chance(15) ? nan : std::clamp(quality, 0.0, 100.0));
    time_s += chance(20) ? 400 : 6;
  }
  return trace;
}

}  // namespace tocsin::tools
