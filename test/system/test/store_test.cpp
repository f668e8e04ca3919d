// SPDX-License-Identifier: Apache-2.0
// A stored topic over an outage of the emulated radio, in which both routers are killed with -9.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "crossing.hpp"
#include "foundation/temporary_folder.hpp"
#include "peer.hpp"
#include "ros_idl/std_msgs.hpp"
#include "shared.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using Message = std_msgs::msg::String;

constexpr TopicInfo live{"history", "history", Scope::host};
constexpr TopicInfo filled{"history/backfilled", "history", Scope::host};
constexpr int outage_s = 6;
constexpr auto period = milliseconds(50);
/// Of lives of the routers. The topic is transient local, and its last sample is sent again
/// whenever two meet.
constexpr std::size_t meetings = 3;
constexpr std::size_t most_samples = 1U << 14U;

/// What the vehicle has written and what the station's readers got, shared by their processes.
struct History {
  struct Got : Receiver {
    void receive(const Sample& sample) override {
      const std::size_t at = count.load(std::memory_order_relaxed);
      if (at == most_samples) return;
      sequences[at] = sample.sequence;
      count.store(at + 1, std::memory_order_release);
    }
    [[nodiscard]] std::vector<std::uint64_t> all() const {
      return {sequences.data(), sequences.data() + count.load(std::memory_order_acquire)};
    }
    std::atomic<std::size_t> count{0};
    std::array<std::uint64_t, most_samples> sequences{};
  };
  std::atomic<std::uint64_t> written{0};
  std::atomic<bool> ends{false};
  Got live;
  Got filled;
};

int count_of(const std::string& text, const std::string& word) {
  int count = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

class StoreTest : public ::testing::Test {
 protected:
  StoreTest() {
    bringup_ = standing(folder_.path(),
                        "extends: traffic.yaml\n"
                        "uxv: {normal: {topics: [history], store: [history]}}\n");
    // What a router that is dead misses, its successor gets from the writer.
    qos_ = folder_.write(
        "qos.yaml", "history: {reliability: reliable, durability: transient_local, depth: 400}\n");
  }
  void start_peers(const Stack& stack) {
    peer(stack.running("uxv/link"), standing_domain, [this](Bus& bus) {
      const auto writer = bus.advertise({live, &type_info<Message>()});
      for (auto next = std::chrono::steady_clock::now(); !history_->ends; next += period) {
        std::this_thread::sleep_until(next);
        if (!writer->has_readers()) continue;  // it would not count as written
        (void)writer->write(std::make_shared<const Message>());
        ++history_->written;
      }
      for (;;) pause();
    });
    peer(stack.running("gcs/link"), standing_domain + 1, [this](Bus& bus) {
      const auto one = bus.subscribe({live, &type_info<Message>()}, history_->live);
      const auto other = bus.subscribe({filled, &type_info<Message>()}, history_->filled);
      for (;;) pause();
    });
  }
  void peer(pid_t process, int domain, const std::function<void(Bus&)>& job) {
    BusOptions options;
    options.qos_file = qos_;
    options.name = "history";
    options.host_domain = domain;
    peers_.push_back(std::make_unique<Peer>(process, options, job));
  }
  /// All that were written, live or backfilled, each once.
  [[nodiscard]] std::vector<std::uint64_t> got() const {
    std::vector<std::uint64_t> all = history_->live.all();
    const auto backfilled = history_->filled.all();
    all.insert(all.end(), backfilled.begin(), backfilled.end());
    std::sort(all.begin(), all.end());
    return all;
  }
  /// From the first on that came after the station's reader was there.
  [[nodiscard]] std::vector<std::uint64_t> missing() const {
    const auto all = got();
    std::vector<std::uint64_t> missing;
    for (std::uint64_t one = all.empty() ? 1 : all.front(); one <= history_->written; ++one) {
      if (!std::binary_search(all.begin(), all.end(), one)) missing.push_back(one);
    }
    return missing;
  }

  [[nodiscard]] std::vector<std::uint64_t> twice() const {
    const auto all = got();
    std::vector<std::uint64_t> twice;
    for (std::size_t i = 1; i < all.size(); ++i) {
      if (all[i - 1] == all[i]) twice.push_back(all[i]);
    }
    return twice;
  }

  TemporaryFolder folder_;
  std::string qos_;
  std::string bringup_;
  Shared<History> history_;
  std::vector<std::unique_ptr<Peer>> peers_;
};

TEST_F(StoreTest, AnOutageWithKilledRoutersLosesNothingAndGivesEachSampleOnceAndInOrder) {
  const Stack stack({bringup_, "--seed", "1"});
  ASSERT_TRUE(routers_run(stack)) << stack.output();
  start_peers(stack);
  const auto crosses = [&] { return history_->live.count > 120; };  // 6 s: routers count as sound
  ASSERT_TRUE(Stack::eventually(seconds(30), crosses)) << stack.output();

  stack.control("radio.sock", fmt::format("set outage {}", outage_s));
  const auto begin = std::chrono::steady_clock::now();
  std::this_thread::sleep_until(begin + seconds(outage_s / 3));
  ASSERT_EQ(kill(stack.pid("uxv/link"), SIGKILL), 0);
  std::this_thread::sleep_until(begin + seconds(2 * outage_s / 3));
  ASSERT_EQ(kill(stack.pid("gcs/link"), SIGKILL), 0);
  std::this_thread::sleep_until(begin + seconds(outage_s));
  history_->ends = true;

  EXPECT_TRUE(Stack::eventually(seconds(60), [&] { return missing().empty(); }))
      << "of " << history_->written << " are missing " << ::testing::PrintToString(missing())
      << "\n"
      << stack.output();
  EXPECT_LE(twice().size(), meetings) << ::testing::PrintToString(twice());
  const auto backfilled = history_->filled.all();
  EXPECT_GT(backfilled.size(), 60U) << "at least what was written in half of the outage";
  EXPECT_TRUE(std::is_sorted(backfilled.begin(), backfilled.end()))
      << "in the order of the writer: " << ::testing::PrintToString(backfilled);
}

TEST_F(StoreTest, ReadersThatFindARestartedRouterLateMissNothingThatCrossed) {
  // What comes to a writer before a reader has found it, the reader never gets.
  qos_ = folder_.write("qos.yaml", "history: {reliability: reliable, depth: 400}\n");
  const Stack stack({bringup_, "--seed", "1"});
  ASSERT_TRUE(routers_run(stack)) << stack.output();
  start_peers(stack);
  const auto crosses = [&] { return history_->live.count > 120; };
  ASSERT_TRUE(Stack::eventually(seconds(30), crosses)) << stack.output();

  Peer& readers = *peers_.at(1);
  const auto routers = [&] { return count_of(stack.output(), "uxv is on the link"); };
  const int before = routers();
  readers.stop();
  ASSERT_EQ(kill(stack.pid("gcs/link"), SIGKILL), 0);
  ASSERT_TRUE(Stack::eventually(seconds(10), [&] { return routers() > before; })) << stack.output();
  std::this_thread::sleep_for(milliseconds(500));  // samples cross
  readers.resume();
  const auto resumed_at = history_->written.load();
  const auto goes_on = [&] {
    const auto got = history_->live.all();
    return !got.empty() && got.back() > resumed_at;
  };
  EXPECT_TRUE(Stack::eventually(seconds(30), goes_on)) << stack.output();
  history_->ends = true;
  EXPECT_TRUE(Stack::eventually(seconds(60), [&] { return missing().empty(); }))
      << "of " << history_->written << " are missing " << ::testing::PrintToString(missing())
      << "\n"
      << stack.output();
}

}  // namespace
}  // namespace tocsin
