// SPDX-License-Identifier: Apache-2.0
// Two containers that talk to each other, and somebody on their network who sends what Fast DDS
// does not stand.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <mutex>
#include <sstream>

#include "foundation/temporary_folder.hpp"
#include "operator_process.hpp"
#include "packet_tap.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"
#include "stack.hpp"
#include "storm.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr int domain = 61;

/// The dropped packets that containers tell of in their diagnostics, by reason.
class DropReports : public Receiver {
 public:
  void receive(const Sample& sample) override {
    const auto& array = *static_cast<const topic::Diagnostics::Message*>(sample.message.get());
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& status : array.status()) {
      if (status.name().find("/packets dropped") == std::string::npos) continue;
      for (const auto& pair : status.values())
        counts_[pair.key()] = std::stoull("0" + pair.value());
    }
  }
  [[nodiscard]] std::uint64_t count(const std::string& reason) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = counts_.find(reason);
    return found == counts_.end() ? 0 : found->second;
  }

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::uint64_t> counts_;
};

BusOptions observer() {
  BusOptions options;
  options.name = "observer";
  options.role = Role::uxv;
  options.host_domain = domain;
  return options;
}

class HostilePackets : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(Stack::eventually(seconds(20), [this] { return heard() > 5; }));
  }
  [[nodiscard]] std::vector<std::string> run(const std::string& component) const {
    return {"/bin/bash", "-c",
            "source " + Stack::setup() + " && exec tocsin-run " + component + " --domain " +
                std::to_string(domain)};
  }
  /// Greetings that the listener has heard.
  [[nodiscard]] std::size_t heard() const {
    std::ifstream file(folder_.path("listener"));
    std::string line;
    std::size_t count = 0;
    while (std::getline(file, line)) count += line.find("] heard ") == std::string::npos ? 0 : 1;
    return count;
  }
  /// Whether the two still talk, and soon.
  [[nodiscard]] bool talks_on() const {
    const std::size_t before = heard();
    return Stack::eventually(seconds(5), [&] { return heard() > before + 10; });
  }
  static void send(const fuzz::Attacker& attacker, const std::vector<fuzz::NamedPacket>& packets) {
    for (const auto& packet : packets) attacker.send_to_all(packet.bytes);
  }

  const TemporaryFolder folder_;
  const OperatorProcess talker_{run("talker --set period_s=0.05"), folder_.path("talker")};
  const OperatorProcess listener_{run("listener"), folder_.path("listener")};
};

TEST_F(HostilePackets, ThatCrashFastDdsAreDroppedAndCounted) {
  DropReports reports;
  const auto bus = make_fast_dds_bus(observer());
  const auto diagnostics = bus->subscribe(
      {topic::Diagnostics::info, &type_info<topic::Diagnostics::Message>()}, reports);
  const fuzz::Attacker attacker;
  const fuzz::Victims victims({talker_.pid(), listener_.pid()});
  send(attacker, fuzz::hostile_from_anybody());
  EXPECT_EQ(victims.complaints(), std::vector<std::string>());
  EXPECT_GE(attacker.announced_by_others(milliseconds(1000)).size(), 2U) << "nobody knows it";
  send(attacker, fuzz::hostile_from_announced());
  EXPECT_EQ(victims.complaints(), std::vector<std::string>());
  EXPECT_TRUE(talks_on());
  for (const char* reason :
       {"vendor_submessage", "inline_qos_offset", "parameter_content", "security_content",
        "sequence_number", "sequence_jump", "sample_size"}) {
    EXPECT_TRUE(Stack::eventually(seconds(5), [&] { return reports.count(reason) > 0; })) << reason;
  }
}

TEST_F(HostilePackets, ThatSayThatOthersHaveLeftKeepNobodyAway) {
  const fuzz::Attacker attacker;
  const auto others = attacker.announced_by_others(milliseconds(1000));
  ASSERT_GE(others.size(), 2U);
  const std::size_t before = heard();
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_TRUE(Stack::eventually(seconds(4), [&] {
    for (const auto& prefix : others) attacker.send_to_all(fuzz::forged_disposal(prefix));
    return std::chrono::steady_clock::now() - begin > seconds(2);
  }));
  EXPECT_GT(heard() - before, 20U);  // of 40 in these two seconds
}

TEST_F(HostilePackets, OfFiveThousandParticipantsCostLittle) {
  const fuzz::Attacker attacker;
  const fuzz::Victims victims({talker_.pid(), listener_.pid()});
  for (std::uint32_t number = 1; number <= 5000; ++number) {
    attacker.send_to_all(fuzz::hostile_announcement({{127, 0, 0, 1}, attacker.port()}, number));
  }
  EXPECT_TRUE(talks_on());
  EXPECT_EQ(victims.complaints(), std::vector<std::string>());
}

TEST_F(HostilePackets, OfEverySortLeaveContainersAsTheyAre) {
  const fuzz::Attacker attacker;
  const fuzz::Victims victims({talker_.pid(), listener_.pid()});
  fuzz::send_storm(attacker, {3000, 3000, 1000, 20261122});
  EXPECT_TRUE(talks_on());
  EXPECT_EQ(victims.complaints(), std::vector<std::string>());
}

/// A router's way over the link, on an interface without another end, beside a peer that is
/// hostile.
TEST(HostilePeer, WhoNamesAThirdAddressDrawsNothingTowardsIt) {
  if (std::system("ip link add wlan0 type veth peer name far && ip link set far up && "
                  "ip addr add 10.77.0.1/24 dev wlan0 && ip addr add 10.77.0.2/24 dev wlan0 && "
                  "ip link set wlan0 up && "
                  "ip neigh add 10.77.0.9 lladdr 02:00:00:00:00:09 dev wlan0") != 0) {
    GTEST_SKIP() << "no right to make an interface";
  }
  const PacketTap tap(getpid());
  const TemporaryFolder folder;
  BusOptions options = observer();
  options.traffic_file = folder.write("traffic.yaml", "uxv: {}\n");
  options.link_domain = domain + 1;
  options.link_address = "10.77.0.1";
  options.link_peers = {"10.77.0.2"};
  options.host = "uxv";
  const auto link = make_fast_dds_link_bus(options, [] {});
  ASSERT_TRUE(Stack::eventually(seconds(5), [&] { return link->self() != 0; }));
  const fuzz::Attacker peer("10.77.0.2");
  for (std::uint32_t number = 1; number <= 50; ++number) {
    peer.send_to_all(fuzz::hostile_announcement({{10, 77, 0, 9}, 7410}, number));
  }
  // A second in which to answer; without the filter 2000 packets go there.
  (void)peer.answers_to(fuzz::hostile_announcement({{10, 77, 0, 9}, 7410}), milliseconds(1000));
  std::size_t to_third = 0;
  for (const TappedPacket& packet : tap.packets()) {
    const std::uint8_t* destination = packet.bytes.data() + 16;
    if (packet.bytes.size() >= 20 && destination[1] == 77 && destination[3] == 9) ++to_third;
  }
  EXPECT_EQ(to_third, 0U);
}

}  // namespace
}  // namespace tocsin
