// SPDX-License-Identifier: Apache-2.0
#include "sim_host.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "foundation/error.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::simulation {
namespace {

const std::string config = TOCSIN_REPOSITORY "/config/";

template <class Topic>
Endpoint endpoint() {
  return {Topic::info, &type_info<typename Topic::Message>()};
}

class Collector : public Receiver {
 public:
  void receive(const Sample& sample) override { samples.push_back(sample); }
  std::vector<Sample> samples;
};

class SimHostTest : public ::testing::Test {
 protected:
  template <class Topic>
  Collector& read(SimProcess& process) {
    collectors_.push_back(std::make_unique<Collector>());
    subscriptions_.push_back(process.subscribe(endpoint<Topic>(), *collectors_.back()));
    return *collectors_.back();
  }
  template <class Topic>
  static std::shared_ptr<const typename Topic::Message> message() {
    return std::make_shared<const typename Topic::Message>();
  }
  void run_for(double s) {
    const Time end = core_.now + seconds(s);
    const auto next = [this] { return std::min(core_.events.next(), link_.next_event()); };
    for (Time at = next(); at <= end; at = next()) {
      core_.now = std::max(core_.now, at);
      core_.events.run(core_.now);
      link_.advance();
    }
    core_.now = end;
  }
  static radio::ChannelParams wire() {
    radio::ChannelParams params;
    params.mode = "bernoulli";
    return params;
  }

  Core core_;
  RadioLink link_{core_, wire(), {}, 1};
  Network network_{core_, link_, QosProfiles(config + "qos.yaml"), {}};
  SimHost uxv_{network_, "uxv", "uxv", config + "traffic_thesis.yaml"};
  SimHost gcs_{network_, "gcs", "gcs", config + "traffic_thesis.yaml"};
  SimProcess& drive_ = uxv_.add_process("drive");
  SimProcess& recorder_ = uxv_.add_process("recorder");
  SimProcess& mission_ = gcs_.add_process("mission");
  SimProcess& view_ = gcs_.add_process("view");
  std::vector<std::unique_ptr<Collector>> collectors_;
  std::vector<std::unique_ptr<Subscription>> subscriptions_;
};

TEST_F(SimHostTest, SampleReachesEveryProcessOfItsHostAtOnceAsTheSameObject) {
  Collector& same = read<topic::Odom>(drive_);
  Collector& other = read<topic::Odom>(recorder_);
  const auto written = message<topic::Odom>();
  EXPECT_EQ(drive_.advertise(endpoint<topic::Odom>())->write(written), Status::ok);
  ASSERT_EQ(same.samples.size(), 1U);
  ASSERT_EQ(other.samples.size(), 1U);
  EXPECT_EQ(other.samples[0].message, written);
  EXPECT_EQ(other.samples[0].received, core_.now);
}

TEST_F(SimHostTest, HostTopicStaysOnItsHost) {
  Collector& away = read<topic::Odom>(mission_);
  (void)drive_.advertise(endpoint<topic::Odom>())->write(message<topic::Odom>());
  run_for(1);
  EXPECT_TRUE(away.samples.empty());
  EXPECT_EQ(link_.pushed(), 0U);
}

TEST_F(SimHostTest, LinkTopicReachesTheOtherSideDecoded) {
  Collector& away = read<topic::Location>(mission_);
  const auto written = message<topic::Location>();
  const Time sent = core_.now;
  (void)drive_.advertise(endpoint<topic::Location>())->write(written);
  EXPECT_TRUE(away.samples.empty());
  run_for(1);
  ASSERT_EQ(away.samples.size(), 1U);
  EXPECT_EQ(away.samples[0].message, written);  // never changed, so not copied
  EXPECT_GT(away.samples[0].bytes, 0U);
  EXPECT_EQ(away.samples[0].sent_wall_ns, Core::wall_ns(sent));
  EXPECT_GT(away.samples[0].received, sent);
  EXPECT_EQ(away.samples[0].sequence, 1U);
}

TEST_F(SimHostTest, EachReadingProcessCostsACopyOnTheRadio) {
  Collector& first = read<topic::Location>(mission_);
  Collector& second = read<topic::Location>(view_);
  Collector& same_process = read<topic::Location>(view_);
  (void)drive_.advertise(endpoint<topic::Location>())->write(message<topic::Location>());
  run_for(1);
  EXPECT_EQ(link_.pushed(), 2U);
  for (const Collector* one : {&first, &second, &same_process}) {
    EXPECT_EQ(one->samples.size(), 1U);
  }
}

TEST_F(SimHostTest, NothingIsSentWithoutAReaderOnTheOtherSide) {
  (void)drive_.advertise(endpoint<topic::Location>())->write(message<topic::Location>());
  run_for(1);
  EXPECT_EQ(link_.pushed(), 0U);
}

TEST_F(SimHostTest, ClosedGateKeepsAPausableTopicOffTheRadioOnly) {
  Collector& here = read<topic::CpuLoad>(recorder_);
  Collector& away = read<topic::CpuLoad>(mission_);
  const auto sut = drive_.advertise(endpoint<topic::CpuLoad>());
  drive_.set_gate(false);
  EXPECT_EQ(sut->write(message<topic::CpuLoad>()), Status::paused);
  run_for(10);
  EXPECT_EQ(here.samples.size(), 1U);
  EXPECT_TRUE(away.samples.empty());
  EXPECT_EQ(link_.pushed(), 0U);
  ASSERT_EQ(drive_.link_traffic().size(), 1U);
  EXPECT_EQ(drive_.link_traffic()[0].dropped, 1U);
}

TEST_F(SimHostTest, ClosedGateLetsCriticalTopicsPass) {
  Collector& away = read<topic::Heartbeat>(mission_);
  drive_.set_gate(false);
  (void)drive_.advertise(endpoint<topic::Heartbeat>())->write(message<topic::Heartbeat>());
  run_for(1);
  EXPECT_EQ(away.samples.size(), 1U);
}

TEST_F(SimHostTest, GateOfOneProcessLeavesTheOthersAlone) {
  Collector& away = read<topic::CpuLoad>(mission_);
  drive_.set_gate(false);
  (void)recorder_.advertise(endpoint<topic::CpuLoad>())->write(message<topic::CpuLoad>());
  run_for(1);
  EXPECT_EQ(away.samples.size(), 1U);
}

TEST_F(SimHostTest, KeptGoalIsSentWhenTheGateOpens) {
  Collector& away = read<topic::Goal>(drive_);
  const auto sut = mission_.advertise(endpoint<topic::Goal>());
  mission_.set_gate(false);
  for (int i = 0; i < 3; ++i) (void)sut->write(message<topic::Goal>());
  run_for(4);
  EXPECT_TRUE(away.samples.empty());
  mission_.set_gate(true);
  run_for(1);
  EXPECT_EQ(away.samples.size(), 1U);
}

TEST_F(SimHostTest, KeptGoalIsDroppedWhenTheGateOpensAfterItsLifespan) {
  Collector& away = read<topic::Goal>(drive_);
  const auto sut = mission_.advertise(endpoint<topic::Goal>());
  mission_.set_gate(false);
  (void)sut->write(message<topic::Goal>());
  run_for(6);  // a command lives for 5 s
  mission_.set_gate(true);
  run_for(1);
  EXPECT_TRUE(away.samples.empty());
}

TEST_F(SimHostTest, LateReaderOfItsHostGetsTheLastState) {
  (void)drive_.advertise(endpoint<topic::NavigationStatus>())
      ->write(message<topic::NavigationStatus>());
  EXPECT_EQ(read<topic::NavigationStatus>(drive_).samples.size(), 1U);
  EXPECT_EQ(read<topic::NavigationStatus>(recorder_).samples.size(), 1U);
}

TEST_F(SimHostTest, LateReaderOfTheOtherHostGetsTheLastState) {
  (void)drive_.advertise(endpoint<topic::NavigationStatus>())
      ->write(message<topic::NavigationStatus>());
  Collector& away = read<topic::NavigationStatus>(mission_);
  run_for(1);
  EXPECT_EQ(away.samples.size(), 1U);
}

TEST_F(SimHostTest, DestroyedSubscriptionGetsNothing) {
  Collector& away = read<topic::Location>(mission_);
  const auto sut = drive_.advertise(endpoint<topic::Location>());
  subscriptions_.clear();
  (void)sut->write(message<topic::Location>());
  run_for(1);
  EXPECT_TRUE(away.samples.empty());
}

TEST_F(SimHostTest, RefusesATopicThatItsRoleMayNotSend) {
  EXPECT_THROW((void)mission_.advertise(endpoint<topic::CpuLoad>()), ConfigError);
}

TEST_F(SimHostTest, RefusesASecondTypeForATopic) {
  (void)drive_.advertise(endpoint<topic::Odom>());
  const Endpoint other{topic::Odom::info, &type_info<topic::Imu::Message>()};
  EXPECT_THROW((void)drive_.advertise(other), ConfigError);
  EXPECT_THROW((void)recorder_.advertise(other), ConfigError);
}

/// Keeps what it is shown of one topic.
class Watcher : public Observer {
 public:
  void on_written(const Written& one) override { written.push_back(one.sequence); }
  void on_sent(const Sent& one) override { sent.push_back(one.written); }
  void on_delivered(const Delivered& one) override {
    delivered.push_back(one.written);
    delay = one.received - one.written_at;
    process = one.to.process;
  }
  void on_gate(const GateChange& change) override { gates.push_back(change.open); }
  std::vector<std::uint64_t> written;
  std::vector<std::uint64_t> sent;
  std::vector<std::uint64_t> delivered;
  std::vector<bool> gates;
  Duration delay{0};
  std::string process;
};

TEST_F(SimHostTest, ObserverSeesASampleFromItsWritingToItsDelivery) {
  Watcher watcher;
  core_.observer = &watcher;
  read<topic::Goal>(drive_);
  const auto writer = mission_.advertise(endpoint<topic::Goal>());
  (void)writer->write(message<topic::Goal>());
  run_for(1);
  EXPECT_EQ(watcher.written, (std::vector<std::uint64_t>{1}));
  EXPECT_EQ(watcher.sent, (std::vector<std::uint64_t>{1}));
  EXPECT_EQ(watcher.delivered, (std::vector<std::uint64_t>{1}));
  EXPECT_GT(watcher.delay, Duration{0});
  EXPECT_EQ(watcher.process, "drive");
}

TEST_F(SimHostTest, ObserverKnowsASampleAgainThatTheGateHadKept) {
  Watcher watcher;
  core_.observer = &watcher;
  read<topic::Goal>(drive_);
  const auto writer = mission_.advertise(endpoint<topic::Goal>());
  mission_.set_gate(false);
  (void)writer->write(message<topic::Goal>());
  (void)writer->write(message<topic::Goal>());
  run_for(1);
  EXPECT_TRUE(watcher.sent.empty());
  mission_.set_gate(true);
  run_for(1);
  EXPECT_EQ(watcher.sent, (std::vector<std::uint64_t>{2}));
  EXPECT_EQ(watcher.delivered, (std::vector<std::uint64_t>{2}));
  EXPECT_GT(watcher.delay, seconds(1));
  EXPECT_EQ(watcher.gates, (std::vector<bool>{false, true}));
}

TEST_F(SimHostTest, EveryWriteIsInTheDigest) {
  const std::uint64_t before = core_.digest.value();
  (void)drive_.advertise(endpoint<topic::Odom>())->write(message<topic::Odom>());
  EXPECT_NE(core_.digest.value(), before);
  EXPECT_EQ(core_.samples, 1U);
}

}  // namespace
}  // namespace tocsin::simulation
