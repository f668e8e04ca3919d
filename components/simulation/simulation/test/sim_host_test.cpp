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
  Network network_{core_, link_, QosProfiles(config + "qos.yaml")};
  SimHost uxv_{network_, "uxv", Role::uxv, config + "traffic_thesis.yaml"};
  SimHost gcs_{network_, "gcs", Role::gcs, config + "traffic_thesis.yaml"};
  SimProcess& drive_ = uxv_.add_process("drive");
  SimProcess& recorder_ = uxv_.add_process("recorder");
  SimProcess& mission_ = gcs_.add_process("mission");
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

TEST_F(SimHostTest, LateReaderOfItsHostGetsTheLastState) {
  (void)drive_.advertise(endpoint<topic::NavigationStatus>())
      ->write(message<topic::NavigationStatus>());
  EXPECT_EQ(read<topic::NavigationStatus>(drive_).samples.size(), 1U);
  EXPECT_EQ(read<topic::NavigationStatus>(recorder_).samples.size(), 1U);
}

TEST_F(SimHostTest, WithoutARouterEachTopicStaysOnItsHost) {
  Collector& here = read<topic::Location>(recorder_);
  Collector& away = read<topic::Location>(mission_);
  Collector& odom_away = read<topic::Odom>(mission_);
  const std::uint64_t before = core_.digest.value();
  (void)drive_.advertise(endpoint<topic::Location>())->write(message<topic::Location>());
  EXPECT_NE(core_.digest.value(), before);
  EXPECT_EQ(core_.samples, 1U);
  (void)drive_.advertise(endpoint<topic::Odom>())->write(message<topic::Odom>());
  run_for(1);
  EXPECT_EQ(here.samples.size(), 1U);
  EXPECT_TRUE(away.samples.empty());
  EXPECT_TRUE(odom_away.samples.empty());
  EXPECT_EQ(link_.pushed(), 0U);
  subscriptions_.clear();
  (void)drive_.advertise(endpoint<topic::Location>())->write(message<topic::Location>());
  EXPECT_EQ(here.samples.size(), 1U) << "nobody is subscribed any more";
}

TEST_F(SimHostTest, RefusesATopicThatItsRoleMayNotSendAndASecondType) {
  EXPECT_THROW((void)mission_.advertise(endpoint<topic::CpuLoad>()), ConfigError);
  (void)drive_.advertise(endpoint<topic::Odom>());
  const Endpoint other{topic::Odom::info, &type_info<topic::Imu::Message>()};
  for (SimProcess* process : {&drive_, &recorder_}) {
    EXPECT_THROW((void)process->advertise(other), ConfigError);
  }
}

}  // namespace
}  // namespace tocsin::simulation
