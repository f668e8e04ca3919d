// SPDX-License-Identifier: Apache-2.0
// The program between two real namespaces.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "harness.hpp"

namespace tocsin::link {
namespace {

using ::testing::HasSubstr;

const char* bernoulli = "radio_channel: {mode: bernoulli, loss: 0.1, delay_s: 0.002}";

/// Sends `count` numbered datagrams in small bursts; returns those that arrive. Waits for the last
/// of each: four bursts that an emulator without a processor finds in its queue fill it.
std::set<int> stream(UdpSocket& from, UdpSocket& to, int count) {
  std::set<int> arrived;
  for (int i = 0; i < count; ++i) {
    from.send(i, 100);
    if (i % 25 != 24 && i + 1 < count) continue;
    const int timeout_ms = i + 1 < count ? 50 : 500;
    while (const auto number = to.receive(timeout_ms)) {
      arrived.insert(*number);
      if (*number == i) break;
    }
  }
  return arrived;
}

/// Whether a datagram comes through.
bool passes(UdpSocket& from, UdpSocket& to) {
  from.send(1, 100);
  return to.receive(300).has_value();
}

TEST_F(LinkEmulator, CarriesEveryPacketBothWaysOverAGoodLink) {
  Emulator sut(open_channel);
  ASSERT_TRUE(sut.ready());
  Ends ends;
  EXPECT_EQ(stream(ends.uxv, ends.gcs, 500).size(), 500u);
  EXPECT_EQ(stream(ends.gcs, ends.uxv, 500).size(), 500u);
  const auto stats = sut.next_stats();
  EXPECT_EQ(stats["uplink"]["delivered"], 500);
  EXPECT_EQ(stats["downlink"]["delivered"], 500);
  EXPECT_EQ(stats["write_errors"], 0);
}

TEST_F(LinkEmulator, LosesTheShareItIsTold) {
  Emulator sut(bernoulli);
  ASSERT_TRUE(sut.ready());
  Ends ends;
  constexpr int sent = 5000;
  const auto arrived = static_cast<int>(stream(ends.uxv, ends.gcs, sent).size());
  EXPECT_NEAR(arrived, 0.9 * sent, 4.5 * std::sqrt(sent * 0.1 * 0.9));
  const auto stats = sut.next_stats();
  EXPECT_EQ(stats["uplink"]["pushed"], sent);
  EXPECT_EQ(stats["uplink"]["delivered"], arrived);
  EXPECT_EQ(stats["uplink"]["losses"], sent - arrived);
}

TEST_F(LinkEmulator, DelaysByTheModelsDelayInTheMedian) {
  Emulator sut("radio_channel: {mode: bernoulli, loss: 0, delay_s: 0.005}");
  ASSERT_TRUE(sut.ready());
  Ends ends;
  std::vector<double> delays_ms;
  for (int i = 0; i < 101; ++i) {
    const auto before = std::chrono::steady_clock::now();
    ends.uxv.send(i, 100);
    ASSERT_TRUE(ends.gcs.receive(2000));
    const std::chrono::duration<double> delay = std::chrono::steady_clock::now() - before;
    delays_ms.push_back(1000 * delay.count());
  }
  std::nth_element(delays_ms.begin(), delays_ms.begin() + 50, delays_ms.end());
  EXPECT_GE(*std::min_element(delays_ms.begin(), delays_ms.end()), 5.0);
  EXPECT_LT(delays_ms[50], 8.0);
}

TEST_F(LinkEmulator, KeepsInterfaceAndAddressWhenKilledAndCarriesOnAfterARestart) {
  Emulator sut(open_channel);
  ASSERT_TRUE(sut.ready());
  Ends ends;
  EXPECT_TRUE(passes(ends.uxv, ends.gcs));
  sut.signal(SIGKILL);
  EXPECT_EQ(sut.wait(), -SIGKILL);
  EXPECT_TRUE(loses_carrier(Namespaces::uxv()));
  const InterfaceState orphan = interface_state(Namespaces::uxv());
  EXPECT_TRUE(orphan.exists);
  EXPECT_EQ(orphan.address, "10.77.0.1");
  EXPECT_FALSE(passes(ends.uxv, ends.gcs));
  sut.start();
  ASSERT_TRUE(sut.ready());
  EXPECT_TRUE(passes(ends.uxv, ends.gcs));
  EXPECT_TRUE(passes(ends.gcs, ends.uxv));
}

TEST_F(LinkEmulator, ObeysCommandsAndCountsMalformedOnes) {
  Emulator sut(bernoulli);
  ASSERT_TRUE(sut.ready());
  for (const char* text : {"pos 3 4", "nonsense", "set loss 7", "pos x y", "set loss 1"}) {
    sut.command(text);
  }
  const auto stats = sut.next_stats();
  EXPECT_EQ(stats["x_m"], 3);
  EXPECT_EQ(stats["y_m"], 4);
  EXPECT_EQ(stats["commands"], 5);
  EXPECT_EQ(stats["bad_commands"], 3);
  Ends ends;
  EXPECT_FALSE(passes(ends.uxv, ends.gcs));
  sut.command("set loss 0");
  EXPECT_TRUE(passes(ends.uxv, ends.gcs));
}

TEST_F(LinkEmulator, ReceivesNothingInAnOutage) {
  Emulator sut(open_channel);
  ASSERT_TRUE(sut.ready());
  Ends ends;
  sut.command("set outage 3");
  EXPECT_FALSE(passes(ends.uxv, ends.gcs));
  EXPECT_FALSE(passes(ends.gcs, ends.uxv));
  nlohmann::json stats = sut.next_stats();
  while (!stats.is_null() && stats["associated"] == true) stats = sut.next_stats();
  EXPECT_EQ(stats["quality"], 0);
  while (!stats.is_null() && stats["associated"] == false) stats = sut.next_stats();
  EXPECT_TRUE(passes(ends.uxv, ends.gcs));
}

TEST_F(LinkEmulator, WritesTheWirelessFileOfTheKernel) {
  Emulator sut(open_channel);
  ASSERT_TRUE(sut.ready());
  (void)sut.next_stats();
  std::ifstream file(sut.file("wireless"));
  std::string line;
  for (int i = 0; i < 3; ++i) std::getline(file, line);
  EXPECT_THAT(line, HasSubstr(" wlan0: 0000   70.  "));
}

TEST_F(LinkEmulator, CarriesOnWhenTheWirelessFileCannotBeReplaced) {
  Emulator sut(open_channel);
  ASSERT_TRUE(sut.ready());
  const std::string obstacle = sut.file("wireless.new");
  ASSERT_EQ(::mkdir(obstacle.c_str(), 0700), 0);
  (void)sut.next_stats();
  EXPECT_GT(sut.next_stats()["write_errors"], 0);
  Ends ends;
  EXPECT_TRUE(passes(ends.uxv, ends.gcs));
  ::rmdir(obstacle.c_str());
}

TEST_F(LinkEmulator, ADeletedInterfaceLeavesTheWirelessFileAndCostsNothing) {
  Emulator sut(open_channel);
  ASSERT_TRUE(sut.ready());
  ASSERT_TRUE(delete_interface(Namespaces::uxv()));
  (void)sut.next_stats();
  const double before_s = sut.cpu_s();
  (void)sut.next_stats();  // a second later
  EXPECT_LT(sut.cpu_s() - before_s, 0.3);
  std::ifstream file(sut.file("wireless"));
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(text, HasSubstr("Quality"));
  EXPECT_THAT(text, ::testing::Not(HasSubstr("wlan0")));
  EXPECT_TRUE(interface_state(Namespaces::gcs()).carrier);
  sut.signal(SIGKILL);
  EXPECT_EQ(sut.wait(), -SIGKILL);
  sut.start();  // makes it again
  ASSERT_TRUE(sut.ready());
  Ends ends;
  EXPECT_TRUE(passes(ends.uxv, ends.gcs));
}

TEST_F(LinkEmulator, RemovesItsInterfacesAndSocketOnSigterm) {
  for (const int signal : {SIGTERM, SIGINT}) {
    Emulator sut(open_channel);
    ASSERT_TRUE(sut.ready());
    sut.signal(signal);
    EXPECT_EQ(sut.wait(), 0);
    EXPECT_FALSE(interface_state(Namespaces::uxv()).exists);
    EXPECT_FALSE(interface_state(Namespaces::gcs()).exists);
    EXPECT_NE(::access(sut.file("control").c_str(), F_OK), 0);
  }
}

TEST_F(LinkEmulator, DiesWithItsParent) {
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);  // so that the grandchildren come to us
  const pid_t parent = ::fork();
  if (parent == 0) {
    auto* sut = new Emulator(open_channel);  // not destroyed: the parent just vanishes
    ::_exit(sut->ready() ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(parent, &status, 0), parent);
  EXPECT_EQ(status, 0);
  int ended = 0;  // hangs into the test's timeout when one does not end
  for (; ::waitpid(-1, &status, 0) > 0; ++ended) EXPECT_EQ(status, 0);
  EXPECT_EQ(ended, 2) << "the emulator, and what removes the temporary folder";
}

std::vector<std::string> arguments(const std::string& channel, const std::string& uxv) {
  return {"--channel", channel,
          "--end",     "uxv:" + uxv + ":10.77.0.1/24",
          "--end",     "gcs:" + Namespaces::gcs() + ":10.77.0.2/24"};
}

void expect_one_line(const ProgramEnd& end, int code, const std::string& part) {
  EXPECT_EQ(end.code, code) << end.text;
  EXPECT_EQ(std::count(end.text.begin(), end.text.end(), '\n'), 1) << end.text;
  EXPECT_THAT(end.text, HasSubstr(part));
}

TEST_F(LinkEmulator, EndsWithTwoOnABadFileOrNamespace) {
  const TemporaryFolder folder;
  const std::string bad = folder.write("bad.yaml", "radio_channel: {loss: 2}");
  const std::string good = folder.write("good.yaml", bernoulli);
  const std::string uxv = Namespaces::uxv();
  expect_one_line(run_to_end(arguments(bad, uxv), false), 2, "loss: 2 is outside [0, 1]");
  expect_one_line(run_to_end(arguments("/nowhere", uxv), false), 2, "/nowhere");
  expect_one_line(run_to_end(arguments(good, "/nowhere"), false), 2, "/nowhere");
  expect_one_line(run_to_end(arguments(good, good), false), 2, "is not a network namespace");
  expect_one_line(run_to_end({"--magic"}, false), 2, "link_emulator");
}

TEST_F(LinkEmulator, EndsWithOneAndSaysWhatItNeedsWithoutPrivilege) {
  const TemporaryFolder folder;
  const std::string good = folder.write("good.yaml", bernoulli);
  expect_one_line(run_to_end(arguments(good, Namespaces::uxv()), true), 1, "needs CAP_SYS_ADMIN");
}

TEST_F(LinkEmulator, EndsWithOneWhenTheInterfaceIsTaken) {
  Emulator first(open_channel);
  ASSERT_TRUE(first.ready());
  const auto end = run_to_end(arguments(first.file("channel.yaml"), Namespaces::uxv()), false);
  expect_one_line(end, 1, "no other process on it");
}

}  // namespace
}  // namespace tocsin::link
