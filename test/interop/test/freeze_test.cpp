// SPDX-License-Identifier: Apache-2.0
// A process that is stopped for longer than its lease, and goes on. The lease of ours is 5 s, that
// of Cyclone DDS 10 s, that of Fast DDS 20 s.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <list>
#include <optional>

#include "peer_process.hpp"
#include "within.hpp"

namespace tocsin::interop {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using std::chrono::steady_clock;
using ::testing::IsEmpty;

/// Ours and one of another vendor on a domain of their own; one of the two will be stopped.
struct Pair {
  Pair(const std::string& maker, bool stops_ours, seconds time, int domain)
      : ours("tocsin", domain, "ours"),
        theirs(maker, domain, maker),
        stopped(stops_ours ? ours : theirs),
        duration(time) {}
  [[nodiscard]] std::string name() const {
    return stopped.name() + " of ours and " + theirs.name() + ", for " +
           std::to_string(duration.count()) + " s";
  }
  [[nodiscard]] bool hear_each_other(steady_clock::time_point since = {}) const {
    return ours.has_heard(theirs, since) && theirs.has_heard(ours, since);
  }
  PeerProcess ours;
  PeerProcess theirs;
  PeerProcess& stopped;
  const seconds duration;
  steady_clock::time_point stopped_at{};
  steady_clock::time_point went_on_at{};
  std::optional<milliseconds> heard_after;

  void look(steady_clock::time_point now) {
    if (went_on_at == steady_clock::time_point{}) {
      if (now - stopped_at < duration) return;
      stopped.thaw();
      went_on_at = now;
    } else if (!heard_after && hear_each_other(went_on_at)) {
      heard_after = std::chrono::duration_cast<milliseconds>(now - went_on_at);
    }
  }
};

/// All at the same time. Seconds, from $TOCSIN_FREEZES or as given.
std::list<Pair> pairs(std::vector<int> durations) {
  if (const char* const text = std::getenv("TOCSIN_FREEZES")) durations = {std::atoi(text)};
  std::list<Pair> all;
  int domain = 20;
  for (const char* const maker : {"cyclone", "fast_dds"}) {
    for (const int duration : durations) {
      for (const bool stops_ours : {true, false}) {
        all.emplace_back(maker, stops_ours, seconds(duration), domain++);
      }
    }
  }
  return all;
}

constexpr seconds patience{10};

/// They take up to half a second on a machine that has time; without a repair they never hear
/// again.
TEST(Freeze, EitherSideIsHeardAgainSoonAfterItsReturn) {
  auto sut = pairs({7, 12});
  for (Pair& one : sut) {
    ASSERT_TRUE(within(patience, [&] { return one.hear_each_other(); })) << one.name();
    one.stopped.freeze();
    one.stopped_at = steady_clock::now();
  }
  const auto is_over = [&] {
    bool over = true;
    for (Pair& one : sut) {
      one.look(steady_clock::now());
      over = over && one.heard_after.has_value();
    }
    return over;
  };
  (void)within(seconds(75), is_over);
  for (const Pair& one : sut) {
    if (one.heard_after) {
      std::cout << one.name() << ": heard after " << one.heard_after->count() << " ms\n";
    }
    EXPECT_LE(one.heard_after.value_or(patience), seconds(4)) << one.name();
  }
}

TEST(Restart, TheSuccessorOfAProcessThatWasKilledIsHeardAndHearsWithinASecond) {
  int domain = 30;
  for (const char* const maker : {"cyclone", "fast_dds"}) {
    const PeerProcess steady(maker, domain, "steady");
    PeerProcess ours("tocsin", domain, "ours");
    PeerProcess theirs(maker, domain, "theirs");
    const auto all_hear = [](const PeerProcess& one, const PeerProcess& other) {
      return one.has_heard(other) && other.has_heard(one);
    };
    ASSERT_TRUE(within(patience, [&] { return all_hear(ours, theirs) && all_hear(ours, steady); }))
        << maker;
    ours.kill();
    theirs.kill();
    const PeerProcess our_next("tocsin", domain, "our_next");
    const PeerProcess their_next(maker, domain, "their_next");
    EXPECT_TRUE(within(seconds(2), [&] {  // a second, and what it takes to start them
      return all_hear(our_next, their_next) && all_hear(our_next, steady);
    })) << maker;
    ++domain;
  }
}

}  // namespace
}  // namespace tocsin::interop
