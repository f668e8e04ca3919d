// SPDX-License-Identifier: Apache-2.0
#include "watch/patient_clock.hpp"

#include <gtest/gtest.h>
#include <sched.h>

#include <atomic>
#include <sstream>
#include <thread>

namespace tocsin {
namespace {

constexpr std::uint64_t second_ns = 1'000'000'000;
const Time t0{seconds(1000)};

TEST(ProcessorWait, IsTheSecondNumberOfSchedstat) {
  std::istringstream text("81234567 4567 89\n");
  EXPECT_EQ(processor_wait(text), 4567U);
  std::istringstream disabled("0");
  EXPECT_EQ(processor_wait(disabled), std::nullopt);
  std::istringstream none("");
  EXPECT_EQ(processor_wait(none), std::nullopt);
}

/// Spins on the processor of whoever made it.
class Rival {
 public:
  Rival() : thread_([this] { spin(); }) {}
  ~Rival() {
    ends_ = true;
    thread_.join();
  }
  Rival(const Rival&) = delete;
  Rival& operator=(const Rival&) = delete;

 private:
  void spin() const {
    while (!ends_) {
    }
  }
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

TEST(ProcessorWait, GrowsForThreadsThatShareAProcessor) {
  cpu_set_t before;
  ASSERT_EQ(::sched_getaffinity(0, sizeof before, &before), 0);
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(static_cast<unsigned>(::sched_getcpu()), &one);
  ASSERT_EQ(::sched_setaffinity(0, sizeof one, &one), 0);  // inherited by threads that it starts
  const auto longest = [] {
    std::uint64_t found = 0;
    for (const auto& [thread, waited] : processor_waits()) found = std::max(found, waited);
    return found;
  };
  const bool is_told = !processor_waits().empty();
  const std::uint64_t at_first = longest();
  {
    const Rival rival;
    while (is_told && longest() < at_first + second_ns / 50) {
    }
  }
  ::sched_setaffinity(0, sizeof before, &before);
  if (!is_told) GTEST_SKIP() << "the kernel has no /proc/self/task/*/schedstat";
}

TEST(PatientClock, IsTheTimeWhileNobodyWaits) {
  PatientClock sut;
  EXPECT_EQ(sut.at(t0, {}), t0);
  EXPECT_EQ(sut.at(t0 + seconds(1), {{7, 0}}), t0 + seconds(1));
  EXPECT_EQ(sut.at(t0 + seconds(5), {{7, 0}, {8, 0}}), t0 + seconds(5));
}

TEST(PatientClock, DoesNotCountWhatTheHungriestThreadWaited) {
  PatientClock sut;
  (void)sut.at(t0, {{7, 5 * second_ns}, {8, 0}});
  const Time after = sut.at(t0 + seconds(4), {{7, 6 * second_ns}, {8, 3 * second_ns}});
  EXPECT_EQ(after, t0 + seconds(1));
  EXPECT_EQ(sut.at(t0 + seconds(6), {{7, 6 * second_ns}, {8, 3 * second_ns}}), t0 + seconds(3));
}

TEST(PatientClock, CountsATenthWhateverWaits) {
  PatientClock sut;
  (void)sut.at(t0, {{7, 0}});
  EXPECT_EQ(sut.at(t0 + seconds(10), {{7, 100 * second_ns}}), t0 + seconds(1));
}

TEST(PatientClock, TakesAThreadOfAKnownIdThatHasWaitedLessForANewOne) {
  PatientClock sut;
  (void)sut.at(t0, {{7, 50 * second_ns}});
  EXPECT_EQ(sut.at(t0 + seconds(4), {{7, second_ns}}), t0 + seconds(3));
}

TEST(PatientClock, ForgetsThreadsThatAreGone) {
  PatientClock sut;
  (void)sut.at(t0, {{7, 0}, {8, 0}});
  (void)sut.at(t0 + seconds(1), {{7, 0}});
  EXPECT_EQ(sut.at(t0 + seconds(3), {{7, 0}, {8, second_ns}}), t0 + seconds(2));
}

}  // namespace
}  // namespace tocsin
