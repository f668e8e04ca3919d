// SPDX-License-Identifier: Apache-2.0
#include "command_line/stop_signal.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>

namespace tocsin {
namespace {

TEST(StopSignal, EndsASleep) {
  catch_stop_signals();
  EXPECT_FALSE(is_stopped());
  const Time begin = std::chrono::steady_clock::now();
  sleep_until_stopped(begin + std::chrono::milliseconds(1));
  EXPECT_GE(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(1));
  (void)std::raise(SIGTERM);
  EXPECT_TRUE(is_stopped());
  sleep_until_stopped(never);
}

}  // namespace
}  // namespace tocsin
