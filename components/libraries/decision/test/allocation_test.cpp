// SPDX-License-Identifier: Apache-2.0
// The sample path must not allocate: operator new is counted.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "decision/qni.hpp"
#include "policy_feed.hpp"

namespace {
long allocations = 0;
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size);
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

TEST(Allocation, DoesNotHappenInAnyPolicyWithAnyDetector) {
  for (const char* policy : policy_names) {
    for (const char* detector : detector_names) {
      PolicyParams params = params_for(policy);
      params.detector = *value_of<DetectorKind>(detector);
      const auto sut = make_policy(params);
      const long before = allocations;
      for (int n = 0; n < 5000; ++n) {
        sut->foresee(dead_for(n % 50));
        const Time now{std::chrono::seconds(n)};
        const double x = n < 4000 ? quality(n) : 80 - 0.01 * (n - 4000);  // ends in a long ramp
        (void)sut->on_sample({now, x}, now);
        (void)sut->on_deadline(now);
      }
      EXPECT_EQ(allocations - before, 0) << policy << ' ' << detector;
    }
  }
}

TEST(Allocation, DoesNotHappenInTheRatioOfAnyTwoLawsNorInTheQualityIndex) {
  const Llr llr{DensityLlr({Family::rician, {80, 9, 0}}, {Family::beta, {6, 10, 0}}, 4)};
  const QniModel index{QniParams{}};
  const long before = allocations;
  double sum = 0;
  for (int n = 0; n < 1000; ++n) {
    sum += index.evaluate({n % 100 * 1.0, -60, {}}).value + llr(n % 100);
  }
  EXPECT_NE(sum, 0);
  EXPECT_EQ(allocations - before, 0);
}

}  // namespace
}  // namespace tocsin::decision
