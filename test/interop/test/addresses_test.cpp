// SPDX-License-Identifier: Apache-2.0
// The address of a host's interface changes while participants of all makers run there, as when
// Wi-Fi gives it another one.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "peer_process.hpp"
#include "within.hpp"

namespace tocsin::interop {
namespace {

using std::chrono::seconds;
using std::chrono::steady_clock;

constexpr seconds patience{10};

bool ip(const std::string& words) { return shell("ip address " + words + "/24 dev eth0"); }

class Addresses : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!cable_.is_there()) GTEST_SKIP() << "no right to make network namespaces";
    for (const char* const maker : {"tocsin", "tocsin", "cyclone", "fast_dds"}) add(maker);
    ASSERT_TRUE(hear_each_other({}));
  }
  [[nodiscard]] bool take_address() {
    before_ = peers_.size();
    return ip("del 10.9.0.1");
  }
  void add(const std::string& maker) {
    const std::string name = maker + "_" + std::to_string(peers_.size());
    peers_.push_back(std::make_unique<PeerProcess>(maker, 170, name));
  }
  /// Ours hear all, and all hear ours, what was written after `since`. Not so participants of
  /// Cyclone DDS that ran when the address went away: they send from it for good.
  [[nodiscard]] bool hear_each_other(steady_clock::time_point since) const {
    return within(patience, [&] { return unheard(since).empty(); });
  }
  [[nodiscard]] std::string unheard(steady_clock::time_point since) const {
    std::string text;
    for (std::size_t i = 0; i < peers_.size(); ++i) {
      for (std::size_t j = 0; j < peers_.size(); ++j) {
        if (!matters(i, j) || peers_[i]->has_heard(*peers_[j], since)) continue;
        text += peers_[i]->name() + " of " + peers_[j]->name() + "\n";
      }
    }
    return text;
  }

 private:
  [[nodiscard]] bool is(const char* maker, std::size_t i) const {
    return peers_[i]->name().find(maker) == 0;
  }
  /// Whether the first should hear the second.
  [[nodiscard]] bool matters(std::size_t i, std::size_t j) const {
    if (i == j || (!is("tocsin", i) && !is("tocsin", j))) return false;
    const auto cannot_send = [&](std::size_t k) { return k < before_ && is("cyclone", k); };
    return !cannot_send(j) && !(cannot_send(i) && j >= before_);
  }
  const OtherComputer cable_;
  std::vector<std::unique_ptr<PeerProcess>> peers_;
  std::size_t before_ = 0;  ///< so many were there when the address went away
};

TEST_F(Addresses, WhoRunsWhenTheAddressChangesIsHeardOnAndSoIsWhoComesLater) {
  ASSERT_TRUE(ip("add 10.9.0.7") && take_address());
  auto changed = steady_clock::now();
  EXPECT_TRUE(hear_each_other(changed)) << unheard(changed);
  for (const char* const maker : {"tocsin", "cyclone", "fast_dds"}) add(maker);
  changed = steady_clock::now();
  EXPECT_TRUE(hear_each_other(changed)) << unheard(changed);
}

TEST_F(Addresses, WhoRunsWhenTheAddressGoesAwayIsHeardOn) {
  ASSERT_TRUE(take_address());
  const auto gone = steady_clock::now();
  EXPECT_TRUE(hear_each_other(gone)) << unheard(gone);
}

}  // namespace
}  // namespace tocsin::interop
