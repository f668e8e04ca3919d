// SPDX-License-Identifier: Apache-2.0
// A sender and a receiver with a link between them that a test can read by eye.
#include <gtest/gtest.h>

#include <deque>
#include <vector>

#include "link_router/link_receiver.hpp"
#include "link_router/link_sender.hpp"

namespace tocsin::router {
namespace {

constexpr Time t0{std::chrono::hours(1)};
constexpr Duration ms = std::chrono::milliseconds(1);

/// Everything that is sent arrives 2 ms later, unless `lossy` says that it does not.
class LinkPair : public ::testing::Test {
 protected:
  LinkPair() {
    sut.on_peer("station", 2, now);
    receiver.on_peer("vehicle", 1);
  }

  void add(StreamId stream, const StreamRule& rule) {
    sut.add_stream(stream, rule);
    receiver.on_stream("vehicle", stream, rule);
    sut.set_wanted("station", stream, true, now);
  }

  void offer(StreamId stream, std::uint64_t sequence, std::size_t bytes = 200) {
    sut.offer(stream, {{7, sequence, now}, bytes, nullptr}, now);
  }

  void run(Duration length) {
    for (const Time end = now + length; now < end; now += ms) {
      while (const auto one = sut.next(now)) {
        sent.push_back(*one);
        if (!lost) air.push_back({now + 2 * ms, *one});
      }
      while (!air.empty() && air.front().first <= now) {
        const Transmission& one = air.front().second;
        const Verdict verdict = receiver.on_arrived(
            "vehicle", {one.stream, one.number, one.sample.origin, one.sample.bytes}, now);
        if (verdict == Verdict::deliver) delivered.push_back(one.sample.origin.sequence);
        air.pop_front();
      }
      while (const auto receipt = receiver.take_receipt(now)) {
        sut.on_receipt("station", receipt->receipt, now);
      }
    }
  }

  Time now = t0;
  LinkSender sut{LinkRouterParams{}, 1};
  LinkReceiver receiver{LinkRouterParams{}, 2};
  bool lost = false;
  std::deque<std::pair<Time, Transmission>> air;
  std::vector<Transmission> sent;
  std::vector<std::uint64_t> delivered;
};

StreamRule rule_of(Priority priority) {
  StreamRule rule;
  rule.name = "heartbeat";
  rule.priority = priority;
  rule.repaired = repairs_by_default(priority);
  return rule;
}

TEST_F(LinkPair, DeliversWhatIsOffered) {
  add(1, rule_of(Priority::critical));
  offer(1, 1);
  run(200 * ms);
  EXPECT_EQ(delivered, (std::vector<std::uint64_t>{1}));
  EXPECT_EQ(sent.size(), 1U);
  EXPECT_EQ(sut.state(now).classes[0].delivered, 1U);
}

TEST_F(LinkPair, RepairsALostSampleAfterATenthOfASecond) {
  add(1, rule_of(Priority::critical));
  lost = true;
  offer(1, 1);
  run(99 * ms);
  EXPECT_EQ(sent.size(), 1U);
  lost = false;
  run(20 * ms);
  EXPECT_EQ(sent.size(), 2U);
  EXPECT_EQ(delivered, (std::vector<std::uint64_t>{1}));
}

TEST_F(LinkPair, DoesNotRepairClassLow) {
  add(1, rule_of(Priority::low));
  lost = true;
  offer(1, 1);
  run(2000 * ms);
  EXPECT_EQ(sent.size(), 1U);
  EXPECT_EQ(sut.state(now).classes[3].lost, 1U);
}

}  // namespace
}  // namespace tocsin::router
