// SPDX-License-Identifier: Apache-2.0
// A process that is killed with -9 in the middle of everything, and its successor.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <csignal>

#include "fast_dds/bus_fixture.hpp"
#include "ros_idl/std_msgs.hpp"

namespace tocsin {
namespace {

const Endpoint text{{"text", "sensor", Scope::host}, &type_info<std_msgs::msg::String>()};
const char* const qos = "sensor: {reliability: reliable, depth: 5}\n";

/// A process that, once told, writes until it is killed. Forked before this process has threads.
class Writer {
 public:
  Writer(int domain) {
    if (pipe(pipe_.data()) != 0) abort();
    child_ = fork();
    if (child_ == 0) run(domain);
  }
  ~Writer() { die(); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  void start() { ASSERT_EQ(write(pipe_[1], "g", 1), 1); }
  void die() {
    if (child_ <= 0) return;
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
    child_ = 0;
  }

 private:
  [[noreturn]] void run(int domain) {
    char told = 0;
    if (read(pipe_[0], &told, 1) != 1) _exit(1);
    const auto bus = make_test_bus(domain, qos);
    const auto writer = bus->advertise(text);
    const auto message = std::make_shared<const std_msgs::msg::String>();
    for (;;) {
      (void)writer->write(message);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }
  std::array<int, 2> pipe_{};
  pid_t child_ = 0;
};

/// The reader is made in a child of its own, too, so that each test starts without threads.
void hear_every_life(int domain) {
  std::array<Writer, 3> lives{{{domain}, {domain}, {domain}}};
  const auto bus = make_test_bus(domain, qos);
  Samples samples;
  const auto reader = bus->subscribe(text, samples);
  std::uint64_t source = 0;
  for (Writer& life : lives) {
    life.start();
    ASSERT_TRUE(eventually([&] {
      const auto all = samples.all();
      return !all.empty() && all.back().source != source;
    }));
    source = samples.all().back().source;
    life.die();
  }
}

// Without DeferredReception one in four took up to a second, waiting for a periodic announcement.
void hear_each_newcomer_soon() {
  Samples samples;
  const auto bus = make_test_bus(35, qos);
  const auto reader = bus->subscribe(text, samples);
  std::vector<std::chrono::steady_clock::duration> taken;
  for (int i = 0; i < 15; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    const std::size_t before = samples.all().size();
    const auto other = make_test_bus(35, qos);
    const auto writer = other->advertise(text);
    ASSERT_TRUE(eventually([&] {
      (void)writer->write(std::make_shared<const std_msgs::msg::String>());
      return samples.all().size() > before;
    }));
    taken.push_back(std::chrono::steady_clock::now() - begin);
  }
  std::sort(taken.begin(), taken.end());
  EXPECT_LT(taken[13], std::chrono::milliseconds(400));  // one may meet a busy machine
}

TEST(RestartTest, OneThatComesIsHeardWithoutWaitingForAPeriodicAnnouncement) {
  EXPECT_EXIT(
      {
        hear_each_newcomer_soon();
        _exit(::testing::Test::HasFailure() ? 1 : 0);
      },
      ::testing::ExitedWithCode(0), "");
}

TEST(RestartTest, AProcessKilledTwiceIsHeardAgain) {
  EXPECT_EXIT(
      {
        hear_every_life(36);
        _exit(::testing::Test::HasFailure() ? 1 : 0);
      },
      ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace tocsin
