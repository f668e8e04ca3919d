// SPDX-License-Identifier: Apache-2.0
#include "engine/pool.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <initializer_list>
#include <map>
#include <set>
#include <vector>

namespace tocsin::experiment {
namespace {

/// A job that ends only when it is killed.
int forever(std::size_t) {
  for (;;) ::pause();
}

TEST(Pool, RunsJobsInProcessesOfTheirOwn) {
  const pid_t here = ::getpid();
  Pool sut(2, [here](std::size_t job) { return ::getpid() == here ? 99 : static_cast<int>(job); });
  sut.start(3);
  sut.start(4);
  EXPECT_FALSE(sut.has_room());
  std::set<int> codes;
  while (const auto end = sut.wait()) {
    EXPECT_EQ(end->exit_code, static_cast<int>(end->job));
    EXPECT_EQ(end->signal, 0);
    codes.insert(end->exit_code);
  }
  EXPECT_EQ(codes, (std::set<int>{3, 4}));
  EXPECT_TRUE(sut.idle());
}

TEST(Pool, SurvivesAJobThatCrashes) {
  Pool sut(1, [](std::size_t) -> int { std::abort(); });
  sut.start(0);
  const auto end = sut.wait();
  ASSERT_TRUE(end);
  EXPECT_EQ(end->signal, SIGABRT);
  EXPECT_TRUE(sut.has_room());
}

/// Ends one job after the other; what each returned, in order.
std::vector<int> one_by_one(Pool& pool, std::initializer_list<std::size_t> jobs) {
  std::vector<int> codes;
  for (const std::size_t job : jobs) {
    pool.start(job);
    const auto end = pool.wait();
    if (!end) return codes;
    codes.push_back(end->signal != 0 ? -end->signal : end->exit_code);
  }
  return codes;
}

TEST(Pool, KeepsWhatAWorkerHasLearntForItsNextJob) {
  int played = 0;
  Pool sut(1, [&played](std::size_t) { return ++played; });
  EXPECT_EQ(one_by_one(sut, {5, 6, 7}), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(played, 0) << "the worker's memory is its own";
}

TEST(Pool, MakesANewWorkerAfterACrash) {
  int played = 0;
  Pool sut(1, [&played](std::size_t job) {
    if (job == 13) std::abort();
    return ++played;
  });
  EXPECT_EQ(one_by_one(sut, {1, 2, 13, 3}), (std::vector<int>{1, 2, -SIGABRT, 1}));
}

TEST(Pool, LosesNoOtherJobToACrash) {
  Pool sut(2, [](std::size_t job) -> int {
    if (job == 0) std::abort();
    return static_cast<int>(job);
  });
  sut.start(0);
  sut.start(7);
  std::map<std::size_t, int> ends;
  while (const auto end = sut.wait()) {
    ends[end->job] = end->signal != 0 ? -end->signal : end->exit_code;
  }
  EXPECT_EQ(ends, (std::map<std::size_t, int>{{0, -SIGABRT}, {7, 7}}));
}

TEST(Pool, TakesTheExitCodeOfAJobThatEndsItsWorker) {
  Pool sut(1, [](std::size_t) -> int { ::_exit(42); });
  EXPECT_EQ(one_by_one(sut, {1, 2}), (std::vector<int>{42, 42}));
}

TEST(Pool, NeedsNoMoreWorkersThanJobsAtATime) {
  Pool sut(3, [](std::size_t) { return static_cast<int>(::getpid() % 200); });
  const auto codes = one_by_one(sut, {1, 2, 3, 4});
  EXPECT_EQ(std::set<int>(codes.begin(), codes.end()).size(), 1U);
}

TEST(Pool, EndsIdleWorkersWhenItStops) {
  Pool sut(2, [](std::size_t) { return 0; });
  (void)one_by_one(sut, {1});
  sut.stop();
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a child is left";
}

TEST(Pool, PlaysOnAfterItWasStopped) {
  Pool sut(1, [](std::size_t job) { return static_cast<int>(job); });
  (void)one_by_one(sut, {1});
  sut.stop();
  EXPECT_EQ(one_by_one(sut, {2}), (std::vector<int>{2}));
}

TEST(Pool, IsIdleAndWaitsForNothingAtFirst) {
  Pool sut(1, forever);
  EXPECT_TRUE(sut.idle());
  EXPECT_TRUE(sut.has_room());
  EXPECT_FALSE(sut.wait());
}

TEST(Pool, NotesAnInterruptInsteadOfDying) {
  Pool sut(1, forever);
  sut.start(0);
  std::raise(SIGINT);
  EXPECT_TRUE(sut.interrupted());
  EXPECT_FALSE(sut.wait());
  sut.stop();
  EXPECT_TRUE(sut.idle());
}

TEST(Pool, ForgetsAnInterruptOfTheOneBefore) {
  {
    const Pool before(1, forever);
    std::raise(SIGTERM);
  }
  const Pool sut(1, forever);
  EXPECT_FALSE(sut.interrupted());
}

TEST(Pool, EndsItsJobsWithItself) {
  Pool sut(2, forever);
  sut.start(0);
  sut.start(1);
  // The destructor must not hang.
}

}  // namespace
}  // namespace tocsin::experiment
