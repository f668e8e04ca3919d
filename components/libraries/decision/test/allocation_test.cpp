// SPDX-License-Identifier: Apache-2.0
// The sample path must not allocate: operator new is counted.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "decision/channel_qni.hpp"
#include "decision/detectors.hpp"
#include "decision/llr.hpp"
#include "decision/policy.hpp"
#include "decision/quality_index.hpp"
#include "decision/research/mean_cusum.hpp"

namespace {
long allocations = 0;
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace tocsin::decision {
namespace {

/// Qualities that visit every branch: good, bad, in between, none.
double quality(int n) {
  if (n % 97 == 0) return std::numeric_limits<double>::quiet_NaN();
  return n % 50 < 30 ? 80 + n % 20 : 30 + n % 25;
}

TEST(Allocation, IsCountedByThisTest) {
  const long before = allocations;
  delete new int(1);
  EXPECT_EQ(allocations - before, 1);
}

TEST(Allocation, DoesNotHappenInAnyPolicy) {
  for (const char* name :
       {"none", "threshold", "tocp", "tocp_dsp", "tocp_reverse", "belief", "legacy"}) {
    PolicyParams params;
    params.policy = name;
    params.mild_alpha = 5;
    const auto sut = make_policy(params);
    const long before = allocations;
    for (int n = 0; n < 5000; ++n) {
      const Time now{std::chrono::seconds(n)};
      (void)sut->on_sample({now, quality(n)}, now);
      (void)sut->on_deadline(now);
    }
    EXPECT_EQ(allocations - before, 0) << name;
  }
}

TEST(Allocation, DoesNotHappenInAPolicyWithAnyDetector) {
  for (const char* detector : {"cusum", "focus", "shiryaev_roberts"}) {
    for (const char* good : {"normal", "beta"}) {
      PolicyParams params;
      params.policy = "tocp_reverse";
      params.detector = detector;
      params.detector_threshold = 8;
      params.good_family = good;
      if (params.good_family == "beta") params.good_parameters = {10.68, 2.41};
      const auto sut = make_policy(params);
      const long before = allocations;
      for (int n = 0; n < 5000; ++n) {
        const Time now{std::chrono::seconds(n)};
        (void)sut->on_sample({now, quality(n)}, now);
      }
      EXPECT_EQ(allocations - before, 0) << detector << ' ' << good;
    }
  }
}

TEST(Allocation, DoesNotHappenWhileLawsAreLearnedButWhenTheyAreApplied) {
  for (const char* laws : {"propose", "apply"}) {
    PolicyParams params;
    params.policy = "tocp_reverse";
    params.laws = laws;
    params.learn_memory_samples = 100;
    const auto sut = make_policy(params);
    long unexpected = 0;
    for (int n = 0; n < 5000; ++n) {
      const Time now{std::chrono::seconds(n)};
      const unsigned applied = sut->learned()->applied;
      const long before = allocations;
      (void)sut->on_sample({now, n % 2 == 0 ? 68.0 : 72.0}, now);
      if (sut->learned()->applied == applied) unexpected += allocations - before;
    }
    EXPECT_EQ(unexpected, 0) << laws;
    EXPECT_EQ(sut->learned()->applied > 0, params.laws == "apply");
  }
}

TEST(Allocation, DoesNotHappenInAnyDetector) {
  const Llr llr{DensityLlr({Family::rician, {80, 9, 0}}, {Family::beta, {6, 10, 0}}, 4)};
  Focus focus;
  ShiryaevRoberts roberts;
  MeanCusum mean(81, 5, 40);
  Cusum cusum;
  const long before = allocations;
  for (int n = 0; n < 5000; ++n) {
    const double x = n < 4000 ? quality(n) : 80 - 0.01 * (n - 4000);  // ends in a long ramp
    focus.add(x);
    roberts.add(llr(x));
    mean.add(x);
    cusum.add(llr(x));
  }
  EXPECT_EQ(allocations - before, 0);
}

TEST(Allocation, DoesNotHappenInAnyQualityIndex) {
  const QniModel first{QniParams{}};
  const ChannelQniModel second{ChannelQniParams{}};
  const QualityIndex index{QualityIndexParams{}};
  QualityIndexParams params;
  params.quality_index = "joint";
  const QualityIndex joint{params};
  const long before = allocations;
  double sum = 0;
  for (int n = 0; n < 1000; ++n) {
    sum += first.evaluate({n % 100 * 1.0, -60, {}}).value;
    sum += second.evaluate({n % 100 * 1.0, -60, 0.5, {}}).value;
    sum += index.evaluate({n % 100 * 1.0, -60, 80, 10, 20});
    sum += joint.evaluate({n % 100 * 1.0, -60, 80, 10, 20, 12});
  }
  EXPECT_GT(sum, 0);
  EXPECT_EQ(allocations - before, 0);
}

}  // namespace
}  // namespace tocsin::decision
