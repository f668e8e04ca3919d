// SPDX-License-Identifier: Apache-2.0
#include "foundation/thread_cpu.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace tocsin {
namespace {

void work(Duration cpu) {
  const Duration begin = thread_cpu();
  while (thread_cpu() - begin < cpu) continue;
}

TEST(ThreadCpu, IsOfTheCallingThreadAlone) {
  const Duration begin = thread_cpu();
  std::thread([] { work(std::chrono::milliseconds(50)); }).join();
  EXPECT_LT(thread_cpu() - begin, std::chrono::milliseconds(50));
  work(std::chrono::milliseconds(2));
  EXPECT_GE(thread_cpu() - begin, std::chrono::milliseconds(2));
}

}  // namespace
}  // namespace tocsin
