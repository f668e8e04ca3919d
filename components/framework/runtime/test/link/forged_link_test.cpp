// SPDX-License-Identifier: Apache-2.0
// Two routers on a plain link, and somebody who speaks in their name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "link/link_bus_fixture.hpp"
#include "runtime/testing/forger.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::ElementsAre;

class ForgedLinkTest : public LinkBusFixture {
 protected:
  ForgedLinkTest() : LinkBusFixture(next_domain()), forger_(options(Role::uxv).link_domain) {}
  void SetUp() override {
    if (!forger_.ok()) GTEST_SKIP() << "no raw socket: CAP_NET_RAW is needed";
  }
  const Forger& forger() const { return forger_; }

 private:
  static int next_domain() {
    static int next = 212;
    return next += 3;
  }
  const Forger forger_;
};

TEST_F(ForgedLinkTest, DepartureIsNotBelievedOfAPeerThatIsHeard) {
  Relay uxv(options(Role::uxv));
  Relay gcs(options(Role::gcs));
  const auto vehicle = process(Role::uxv);
  const auto station = process(Role::gcs);
  Samples there;
  const auto far = station->subscribe(endpoint<topic::Location>(), there);
  const auto writer = vehicle->advertise(endpoint<topic::Location>());
  ASSERT_TRUE(write_until_heard<topic::Location>(*writer, there));
  const auto victim = forger().overhear("uxv");
  ASSERT_TRUE(victim);
  const std::size_t before = there.all().size();
  constexpr std::size_t packets = 60;
  for (std::size_t i = 0; i < packets; ++i) {  // 3 s
    forger().send(Forger::departure_of(*victim), victim->port);
    (void)writer->write(std::make_shared<const topic::Location::Message>());
    std::this_thread::sleep_for(milliseconds(50));
  }
  EXPECT_EQ(gcs.lost_peers(), 0);
  EXPECT_GT(there.all().size() - before, packets / 2);
}

TEST_F(ForgedLinkTest, DepartureOfASilentPeerIsBelievedAfterASecond) {
  std::optional<Relay> uxv;
  uxv.emplace(options(Role::uxv));
  Relay gcs(options(Role::gcs));
  ASSERT_TRUE(eventually([&] { return !gcs.peers().empty(); }));
  const auto begin = std::chrono::steady_clock::now();
  uxv.reset();
  ASSERT_TRUE(eventually([&] { return gcs.lost_peers() == 1; }));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, seconds(3));
}

TEST_F(ForgedLinkTest, ForgedNumbersOfSamplesMuteAFlowForTwoSecondsAtMost) {
  const Relay uxv(options(Role::uxv));
  const Relay gcs(options(Role::gcs));
  const auto vehicle = process(Role::uxv);
  const auto station = process(Role::gcs);
  Samples there;
  const auto far = station->subscribe(endpoint<topic::Location>(), there);
  const auto writer = vehicle->advertise(endpoint<topic::Location>());
  ASSERT_TRUE(write_until_heard<topic::Location>(*writer, there));
  for (const std::uint32_t by : {5U, 1U << 18U, 1U << 30U}) {
    (void)writer->write(std::make_shared<const topic::Location::Message>());
    for (const Forger::Overheard& heard : forger().overhear_all()) {
      forger().send(Forger::exaggerated(heard.announcement, by), heard.port);
    }
    std::this_thread::sleep_for(milliseconds(50));
    const std::size_t before = there.all().size();
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_TRUE(eventually([&] {
      (void)writer->write(std::make_shared<const topic::Location::Message>());
      std::this_thread::sleep_for(milliseconds(20));
      return there.all().size() > before + 5;
    })) << by;
    const auto muted = std::chrono::steady_clock::now() - begin;
    EXPECT_LT(muted, seconds(2)) << by;
  }
}

TEST_F(ForgedLinkTest, StrangersWithEndlessLeasesDoNotLockOutARouterThatComesBack) {
  std::optional<Relay> uxv;
  uxv.emplace(options(Role::uxv));
  Relay gcs(options(Role::gcs));
  ASSERT_TRUE(eventually([&] { return !gcs.peers().empty(); }));
  const auto victim = forger().overhear("uxv");
  ASSERT_TRUE(victim);
  uxv.reset();
  for (std::uint32_t number = 1; number <= 128; ++number) {
    forger().send(Forger::stranger_like(*victim, number), forger().port());
    std::this_thread::sleep_for(milliseconds(2));
  }
  const auto begin = std::chrono::steady_clock::now();
  uxv.emplace(options(Role::uxv));
  const auto vehicle = process(Role::uxv);
  const auto station = process(Role::gcs);
  Samples there;
  const auto far = station->subscribe(endpoint<topic::Location>(), there);
  const auto writer = vehicle->advertise(endpoint<topic::Location>());
  ASSERT_TRUE(write_until_heard<topic::Location>(*writer, there));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, seconds(4));
}

}  // namespace
}  // namespace tocsin
