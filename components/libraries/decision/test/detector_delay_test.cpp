// SPDX-License-Identifier: Apache-2.0
// Mean time between false alarms and delay of each detector, simulated. The expected values were
// found by an independent program; both are simulations, hence 10 %.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>

#include "decision/detectors.hpp"

namespace tocsin::decision {
namespace {

/// Starts a detector afresh and returns a function that takes a sample and tells an alarm.
using Detector = std::function<std::function<bool(double)>()>;

double mean_run(const Detector& detector, Normal truth, int runs) {
  std::mt19937_64 random(1);  // NOLINT: a fixed seed is the point
  std::normal_distribution<double> law(truth.mean, truth.sd);
  long samples = 0;
  for (int i = 0; i < runs; ++i) {
    auto alarm = detector();
    do {
      ++samples;
    } while (!alarm(std::clamp(law(random), 0.0, 100.0)));
  }
  return static_cast<double>(samples) / runs;
}

Detector cusum(Normal bad, double clip, double threshold) {
  return [=] {
    return [llr = NormalLlr(thesis_good, bad, clip), sut = Cusum(), threshold](double x) mutable {
      sut.add(llr(x));
      return sut.alarm(threshold);
    };
  };
}

Detector shiryaev_roberts(double threshold) {
  return [=] {
    return [llr = NormalLlr(), sut = ShiryaevRoberts(), threshold](double x) mutable {
      sut.add(llr(x));
      return sut.alarm(threshold);
    };
  };
}

Detector focus(double threshold) {
  return [=] {
    return [sut = Focus(), threshold](double x) mutable {
      sut.add(x);
      return sut.alarm(threshold);
    };
  };
}

struct Row {
  const char* name;
  Detector detector;
  double between_false_alarms;
  double delay_at_bad;
  double delay_at_60;
  double delay_at_70;
};

void PrintTo(const Row& row, std::ostream* out) { *out << row.name; }

class DetectorDelay : public ::testing::TestWithParam<Row> {};

TEST_P(DetectorDelay, AgreesWithTheReference) {
  const Row& row = GetParam();
  const double sd = thesis_good.sd;
  EXPECT_NEAR(mean_run(row.detector, thesis_good, 1500) / row.between_false_alarms, 1, 0.1);
  EXPECT_NEAR(mean_run(row.detector, thesis_bad, 3000) / row.delay_at_bad, 1, 0.05);
  EXPECT_NEAR(mean_run(row.detector, {60, sd}, 3000) / row.delay_at_60, 1, 0.1);
  EXPECT_NEAR(mean_run(row.detector, {70, sd}, 3000) / row.delay_at_70, 1, 0.1);
}

INSTANTIATE_TEST_SUITE_P(
    Detectors, DetectorDelay,
    ::testing::Values(Row{"cusum", cusum(thesis_bad, 0, 3.6328), 1016.7, 1.04, 5.76, 42.12},
                      Row{"clipped", cusum(thesis_bad, 4, 3.5656), 986.8, 1.05, 5.68, 39.47},
                      Row{"mild", cusum({65, thesis_good.sd}, 0, 5.3468), 1023.9, 1.33, 3.15, 9.17},
                      Row{"shiryaev_roberts", shiryaev_roberts(3.6169), 1003.7, 1.04, 5.75, 39.77},
                      Row{"focus", focus(6.1215), 1012.5, 1.11, 3.19, 8.63}));

}  // namespace
}  // namespace tocsin::decision
