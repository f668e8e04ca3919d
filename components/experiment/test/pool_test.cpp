// SPDX-License-Identifier: Apache-2.0
#include "pool.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <set>

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
  JobEnd end{};
  while (sut.wait(end)) {
    EXPECT_EQ(end.exit_code, static_cast<int>(end.job));
    EXPECT_EQ(end.signal, 0);
    codes.insert(end.exit_code);
  }
  EXPECT_EQ(codes, (std::set<int>{3, 4}));
  EXPECT_TRUE(sut.idle());
}

TEST(Pool, SurvivesAJobThatCrashes) {
  Pool sut(1, [](std::size_t) -> int { std::abort(); });
  sut.start(0);
  JobEnd end{};
  ASSERT_TRUE(sut.wait(end));
  EXPECT_EQ(end.signal, SIGABRT);
  EXPECT_TRUE(sut.has_room());
}

TEST(Pool, NotesAnInterruptInsteadOfDying) {
  Pool sut(1, forever);
  sut.start(0);
  std::raise(SIGINT);
  EXPECT_TRUE(sut.interrupted());
  JobEnd end{};
  EXPECT_FALSE(sut.wait(end));
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
