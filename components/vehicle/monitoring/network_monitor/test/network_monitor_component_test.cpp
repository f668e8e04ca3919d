// SPDX-License-Identifier: Apache-2.0
#include "network_monitor/network_monitor_component.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <deque>
#include <fstream>
#include <iterator>
#include <utility>

#include "devices/computer.hpp"
#include "foundation/error.hpp"
#include "foundation/parameters.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

/// A target that answers at once while `alive`; the reply is read at the next tick.
struct Target {
  bool alive = true;
  int error = 0;
};

class ScriptedEcho final : public EchoDevice {
 public:
  ScriptedEcho(const SimBus& bus, const Target& target) : bus_(bus), target_(target) {}
  SendResult send(std::uint16_t sequence) override {
    if (target_.error != 0) return {bus_.now(), target_.error};
    if (target_.alive) replies_.push_back({sequence, bus_.now() + seconds(0.004)});
    return {bus_.now(), 0};
  }
  std::optional<EchoReply> receive() override {
    if (replies_.empty()) return std::nullopt;
    const auto reply = replies_.front();
    replies_.pop_front();
    return reply;
  }

 private:
  const SimBus& bus_;
  const Target& target_;
  std::deque<EchoReply> replies_;
};

/// A computer with that target and the radio of this one.
Computer with_target(const SimBus& bus, const Target& target) {
  Computer computer = this_computer();
  computer.devices.add<EchoDevice>([&](const EchoTarget&, const Devices::Readable&) {
    return std::make_unique<ScriptedEcho>(bus, target);
  });
  return computer;
}

class NetworkMonitorTest : public ::testing::Test {
 protected:
  NetworkMonitorTest() : file_("monitor_test_" + std::to_string(getpid())) {
    NetworkMonitorComponent::Params params;
    params.interface_name = "lo";
    params.wireless_file = file_;
    sut_ = std::make_unique<NetworkMonitorComponent>(context_, params);
  }
  ~NetworkMonitorTest() override { std::remove(file_.c_str()); }

  void write_wireless(const std::string& columns) const {
    std::ofstream(file_) << " lo: 0000 " << columns << "\n";
  }
  std::vector<topic::NetworkQuality::Message> run(double s) {
    if (!std::exchange(running_, true)) bus_.add(*sut_);
    bus_.run_for(seconds(s));
    return samples_.take();
  }

  SimBus bus_;
  Target target_;
  Computer computer_ = with_target(bus_, target_);
  Context context_ = Context(bus_, "network_monitor", Role::uxv).with_computer(computer_);
  SimReader<topic::NetworkQuality> samples_{bus_};
  std::string file_;
  bool running_ = false;
  std::unique_ptr<NetworkMonitorComponent> sut_;
};

TEST_F(NetworkMonitorTest, PublishesOneSampleASecond) {
  EXPECT_EQ(run(1.9).size(), 0U);
  EXPECT_EQ(run(10).size(), 10U);
}

TEST_F(NetworkMonitorTest, ReportsALivingLink) {
  const auto samples = run(10);
  ASSERT_FALSE(samples.empty());
  EXPECT_EQ(samples.back().per_percent(), 0.0F);
  EXPECT_EQ(samples.back().probes_sent(), 20U);
  EXPECT_EQ(samples.back().probes_received(), 20U);
  EXPECT_FLOAT_EQ(samples.back().rtt_mean_ms(), 4.0F);
  const auto& last = samples.back().stamp();
  EXPECT_NEAR(last.sec() + last.nanosec() * 1e-9, 1'767'225'609.5, 0.5);
  EXPECT_EQ(last.nanosec(), samples.front().stamp().nanosec()) << "once a second";
}

TEST_F(NetworkMonitorTest, TellsWhatItsProbesCost) {
  const auto samples = run(10);
  ASSERT_GE(samples.size(), 8U);
  const std::uint64_t between = samples[7].probe_bytes() - samples[1].probe_bytes();
  EXPECT_EQ(between, 20 * (64U + 28U)) << "one each 0.3 s, with headers";
}

TEST_F(NetworkMonitorTest, ReportsADeadLinkAsHundredPercentLost) {
  target_.alive = false;
  const auto samples = run(10);
  ASSERT_FALSE(samples.empty());
  for (const auto& sample : samples) {
    EXPECT_EQ(sample.per_percent(), 100.0F);
    EXPECT_TRUE(std::isnan(sample.rtt_mean_ms()));
  }
}

TEST_F(NetworkMonitorTest, GoesOnReportingWhenTheNetworkIsGone) {
  (void)run(5);
  target_.error = ENETUNREACH;
  const auto samples = run(10);
  ASSERT_EQ(samples.size(), 10U);
  EXPECT_EQ(samples.back().per_percent(), 100.0F);
  target_.error = 0;
  EXPECT_EQ(run(10).back().per_percent(), 0.0F);
}

TEST_F(NetworkMonitorTest, ReportsTheWirelessFile) {
  write_wireless("35. -75. -94. 0 0 0 0 0 0");
  const auto sample = run(3).back();
  EXPECT_EQ(sample.signal_dbm(), -75.0F);
  EXPECT_EQ(sample.noise_dbm(), -94.0F);
  EXPECT_EQ(sample.quality_percent(), 50.0F);
  EXPECT_TRUE(std::isnan(sample.retry_percent()));
  EXPECT_EQ(sample.wireless_source(), "proc");
  EXPECT_EQ(sample.interface_name(), "lo");
}

TEST_F(NetworkMonitorTest, SaysThatTheHardwareIsAbsent) {
  const auto sample = run(3).back();
  EXPECT_EQ(sample.wireless_source(), "absent");
  EXPECT_TRUE(std::isnan(sample.signal_dbm()));
  EXPECT_TRUE(std::isnan(sample.noise_dbm()));
  EXPECT_TRUE(std::isnan(sample.quality_percent()));
  EXPECT_TRUE(std::isnan(sample.busy_percent()));
}

TEST_F(NetworkMonitorTest, FollowsTheInterfaceThroughALostAssociation) {
  write_wireless("35. -75. -256 0 0 0 0 0 0");
  EXPECT_EQ(run(3).back().signal_dbm(), -75.0F);
  write_wireless("0 0 0 0 0 0 0 0 0");
  EXPECT_TRUE(std::isnan(run(1).back().signal_dbm()));
  write_wireless("50. -60. -256 0 0 0 0 0 0");
  EXPECT_EQ(run(1).back().signal_dbm(), -60.0F);
}

TEST_F(NetworkMonitorTest, ReportsAShortOutageAsItsShareOfTheWindow) {
  (void)run(10);
  target_.alive = false;
  (void)run(1.5);  // five probes
  target_.alive = true;
  EXPECT_FLOAT_EQ(run(2.5).back().per_percent(), 25.0F);
  EXPECT_EQ(run(8).back().per_percent(), 0.0F);
}

/// By what routers report; the computer can send no probe.
class NetworkMonitorByRouters : public ::testing::Test {
 protected:
  NetworkMonitorByRouters() {
    computer_.devices.add<EchoDevice>(
        [](const EchoTarget&, const Devices::Readable&) -> std::unique_ptr<EchoDevice> {
          throw EnvironmentError("no probes here");
        });
    NetworkMonitorComponent::Params params;
    params.loss_from = network::LossSource::routers;
    params.interface_name = "";
    sut_.emplace(context_, params);
    bus_.add(*sut_);
  }
  static topic::LinkState::Message state(const std::string& role, float loss) {
    topic::LinkState::Message state;
    state.role(role);
    state.live_peers(1);
    state.loss(loss);
    return state;
  }
  /// The last sample of two seconds, in which a router says this once.
  topic::NetworkQuality::Message sample_after(const topic::LinkState::Message& state) {
    bus_.publish<topic::LinkState>(state);
    bus_.run_for(seconds(2));
    return samples_.take().back();
  }
  SimBus bus_;
  Computer computer_ = this_computer();
  Context context_ = Context(bus_, "network_monitor", Role::uxv).with_computer(computer_);
  SimReader<topic::NetworkQuality> samples_{bus_};
  std::optional<NetworkMonitorComponent> sut_;
};

TEST_F(NetworkMonitorByRouters, TellsTheLossOfBothWaysOnceASecondAndNoRoundTripTime) {
  bus_.run_for(seconds(3));
  EXPECT_TRUE(samples_.take().empty()) << "no router has said anything";
  EXPECT_FLOAT_EQ(sample_after(state("uxv", 0.5F)).per_percent(), 50);
  bus_.publish<topic::LinkState>(state("uxv", 0.5F));
  bus_.publish<topic::LinkState>(state("gcs", 0.5F));
  bus_.run_for(seconds(2));
  const auto samples = samples_.take();
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_FLOAT_EQ(samples.back().per_percent(), 75);
  EXPECT_EQ(samples.back().probes_sent(), 0U);
  EXPECT_EQ(samples.back().probe_bytes(), 0U);
  EXPECT_TRUE(std::isnan(samples.back().rtt_mean_ms()));
}

TEST_F(NetworkMonitorByRouters, ARouterThatNobodyAnswersLosesAll) {
  auto alone = state("uxv", 0);
  alone.live_peers(0);
  EXPECT_FLOAT_EQ(sample_after(alone).per_percent(), 100);
}

TEST_F(NetworkMonitorByRouters, OfTwoPathsTheFirstCounts) {
  auto two = state("uxv", 0);
  two.paths().resize(2);
  two.paths()[0].loss(0.25F);
  two.paths()[1].loss(0.75F);
  EXPECT_FLOAT_EQ(sample_after(two).per_percent(), 25);
  two.paths()[0].silent(true);
  EXPECT_FLOAT_EQ(sample_after(two).per_percent(), 100);
}

/// A vehicle between two sites, of which one does not answer.
class NetworkMonitorSites : public ::testing::Test {
 protected:
  NetworkMonitorSites() {
    params_.target = "10.77.0.2";
    params_.sites = {"gcs", "south"};
    params_.site_targets = {"10.77.0.2", "10.77.0.3"};
    computer_.devices.add<EchoDevice>([&](const EchoTarget& at, const Devices::Readable&) {
      return std::make_unique<ScriptedEcho>(bus_, at.address == "10.77.0.3" ? south_ : north_);
    });
  }
  void speak_with(const std::string& site) {
    topic::LinkSite::Message message;
    message.data(site);
    bus_.publish<topic::LinkSite>(message);
  }
  /// Of the last sample.
  float per_after(double s) {
    bus_.run_for(seconds(s));
    return samples_.take().back().per_percent();
  }
  SimBus bus_;
  Target north_{false, 0};
  Target south_;
  Computer computer_ = this_computer();
  Context context_ = Context(bus_, "network_monitor", Role::uxv).with_computer(computer_);
  NetworkMonitorComponent::Params params_;
  SimReader<topic::NetworkQuality> samples_{bus_};
};

TEST_F(NetworkMonitorSites, ProbesTheSiteThatItsRouterSpeaksWith) {
  NetworkMonitorComponent sut(context_, params_);
  bus_.add(sut);
  EXPECT_EQ(per_after(10), 100.0F);
  speak_with("south");
  EXPECT_EQ(per_after(3), 0.0F) << "what was lost before does not count";
  speak_with("of another file");
  EXPECT_EQ(per_after(5), 0.0F);
  speak_with("gcs");
  EXPECT_EQ(per_after(3), 100.0F);
}

TEST_F(NetworkMonitorSites, EachNeedsATarget) {
  params_.site_targets.pop_back();
  EXPECT_THROW(NetworkMonitorComponent(context_, params_), ConfigError);
}

TEST(NetworkMonitorOnThisComputer, RefusesATargetOfASiteThatIsNoAddressBeforeItIsNeeded) {
  SimBus bus;
  Context context(bus, "network_monitor", Role::uxv);
  NetworkMonitorComponent::Params params;
  params.target = "127.0.0.1";
  params.sites = {"gcs", "south"};
  params.site_targets = {"127.0.0.1", "nowhere"};
  EXPECT_THROW(NetworkMonitorComponent(context, params), ConfigError);
}

/// A computer whose devices have no descriptors: replies come when the test says so.
class ScriptedDevices {
 public:
  explicit ScriptedDevices(const SimBus& bus) : bus_(bus) {
    using network::WirelessDevice;
    computer.devices.add<EchoDevice>([this](const EchoTarget& target, Devices::Readable on) {
      readable = std::move(on);
      echo_target = target;
      return std::make_unique<Echo>(*this);
    });
    computer.devices.add<WirelessDevice>(
        [this](const WirelessDevice::Address& at, const Devices::Readable&) {
          asked = at.interface + " " + at.file;
          return std::make_unique<Wireless>();
        });
  }
  Computer computer;
  std::deque<EchoReply> replies;
  Devices::Readable readable;
  std::string asked;
  EchoTarget echo_target;
  int sent = 0;

 private:
  class Echo final : public EchoDevice {
   public:
    explicit Echo(ScriptedDevices& devices) : devices_(devices) {}
    SendResult send(std::uint16_t) override {
      return {devices_.bus_.now(), devices_.sent++ == 0 ? 0 : ENETUNREACH};
    }
    std::optional<EchoReply> receive() override {
      if (devices_.replies.empty()) return std::nullopt;
      const EchoReply reply = devices_.replies.front();
      devices_.replies.pop_front();
      return reply;
    }

   private:
    ScriptedDevices& devices_;
  };
  class Wireless final : public network::WirelessDevice {
    network::WirelessReading read() override {
      return network::parse_proc_wireless(
          " wlan0: 0000   50.  -60.  -256        0      0      0      0      0        0\n",
          "wlan0");
    }
  };
  const SimBus& bus_;
};

TEST(NetworkMonitorOnAnotherComputer, UsesItsDevices) {
  SimBus bus;
  ScriptedDevices devices(bus);
  Context context = Context(bus, "network_monitor", Role::uxv).with_computer(devices.computer);
  SimReader<topic::NetworkQuality> samples(bus);
  NetworkMonitorComponent sut(context, {});
  bus.add(sut);
  for (int i = 0; i < 500 && devices.sent == 0; ++i) bus.run_for(seconds(0.001));
  ASSERT_EQ(devices.sent, 1) << "within one and a half periods";
  devices.replies.push_back({0, bus.now() + seconds(0.003)});
  devices.readable();
  bus.run_for(seconds(2.1));
  const auto got = samples.take();
  ASSERT_FALSE(got.empty());
  EXPECT_EQ(devices.asked, "wlan0 /proc/net/wireless");
  EXPECT_EQ(got.back().wireless_source(), "proc");
  EXPECT_EQ(got.back().signal_dbm(), -60.0F);
  EXPECT_EQ(got.back().probes_received(), 1U);
  EXPECT_NEAR(got.back().rtt_max_ms(), 3.5, 0.5);
  EXPECT_GT(got.back().per_percent(), 50.0F);  // all later ones were refused
}

TEST(NetworkMonitorOnAnotherComputer, SendsProbesWithTheDscpOfClassLowUnlessToldOtherwise) {
  SimBus bus;
  ScriptedDevices devices(bus);
  Context context = Context(bus, "network_monitor", Role::uxv).with_computer(devices.computer);
  NetworkMonitorComponent::Params params;
  const NetworkMonitorComponent by_default(context, params);
  EXPECT_EQ(devices.echo_target.dscp, dscp(TrafficClass::low));
  EXPECT_EQ(devices.echo_target.payload_bytes, 64U);
  params.dscp = 46;
  const NetworkMonitorComponent told(context, params);
  EXPECT_EQ(devices.echo_target.dscp, 46);
}

TEST(NetworkMonitorOnAnotherComputer, AsksNoRadioWhenNoInterfaceIsConfigured) {
  SimBus bus;
  ScriptedDevices devices(bus);
  Context context = Context(bus, "network_monitor", Role::uxv).with_computer(devices.computer);
  NetworkMonitorComponent::Params params;
  params.interface_name = "";
  SimReader<topic::NetworkQuality> samples(bus);
  NetworkMonitorComponent sut(context, params);
  bus.add(sut);
  bus.run_for(seconds(3));
  const auto got = samples.take();
  ASSERT_FALSE(got.empty());
  EXPECT_EQ(got.back().wireless_source(), "absent");
  EXPECT_EQ(devices.asked, "");
}

TEST(NetworkMonitorLive, TakesAnotherWindowWhileItRunsAndKeepsItOnARefusal) {
  SimBus bus;
  ScriptedDevices devices(bus);
  Context context = Context(bus, "network_monitor", Role::uxv).with_computer(devices.computer);
  const ComponentEntry entry = make_component_entry<NetworkMonitorComponent>();
  const auto sut = entry.create(context, YAML::Load("{}"), {});
  SimReader<topic::NetworkQuality> samples(bus);
  bus.add(*sut);
  entry.change(*sut, YAML::Load("{window: 3}"), {});
  bus.run_for(seconds(10));
  EXPECT_EQ(samples.take().back().probes_sent(), 3U);
  EXPECT_THROW(entry.change(*sut, YAML::Load("{window: 0}"), {}), ConfigError);
  bus.run_for(seconds(10));
  EXPECT_EQ(samples.take().back().probes_sent(), 3U);
}

TEST(NetworkMonitor, RefusesATargetThatIsNoAddress) {
  SimBus bus;
  Context context{bus, "network_monitor", Role::uxv};
  NetworkMonitorComponent::Params params;
  EXPECT_THROW(NetworkMonitorComponent(context, params), ConfigError);
}

TEST(NetworkMonitorReadme, ShowsTheParameters) {
  std::ifstream file(TOCSIN_SOURCE_DIR "/README.md");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_THAT(text, ::testing::HasSubstr(default_yaml<NetworkMonitorComponent::Params>()));
}

}  // namespace
}  // namespace tocsin
