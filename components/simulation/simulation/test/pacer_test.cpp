// SPDX-License-Identifier: Apache-2.0
// Flow controllers of config/qos.yaml in a world of two hosts.
#include "pacer.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "foundation/temporary_folder.hpp"
#include "sim_host.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::simulation {
namespace {

const std::string config = TOCSIN_REPOSITORY "/config/";

template <class Topic>
Endpoint endpoint() {
  return {Topic::info, &type_info<typename Topic::Message>()};
}

class Counter : public Receiver {
 public:
  void receive(const Sample&) override { ++count; }
  int count = 0;
};

class PacerTest : public ::testing::Test {
 protected:
  PacerTest() {
    folder_.write("qos.yaml",
                  "flow_controllers: {radio: {max_bytes_per_period: 560, period_s: 0.01}}\n"
                  "telemetry: {reliability: best_effort, depth: 1, flow_controller: radio}\n"
                  "stream: {reliability: best_effort, depth: 1, flow_controller: radio}\n"
                  "state: {depth: 1}\n");
  }
  template <class Topic>
  void read(SimProcess& process) {
    subscriptions_.push_back(process.subscribe(endpoint<Topic>(), counter_));
  }
  template <class Topic>
  static void write(SimProcess& process) {
    (void)process.advertise(endpoint<Topic>())
        ->write(std::make_shared<const typename Topic::Message>());
  }
  void run_until(double s) {
    const auto next = [this] { return std::min(core_.events.next(), link_.next_event()); };
    for (Time at = next(); at <= start_time + seconds(s); at = next()) {
      core_.now = std::max(core_.now, at);
      core_.events.run(core_.now);
      link_.advance();
    }
  }
  static radio::ChannelParams wire() {
    radio::ChannelParams params;
    params.mode = "bernoulli";
    return params;
  }
  const TemporaryFolder folder_;
  Core core_;
  RadioLink link_{core_, wire(), {}, 1};
  Counter counter_;
  std::vector<std::unique_ptr<Subscription>> subscriptions_;
};

/// Two processes on the vehicle, one on the ground that reads what they write.
class PacedWorldTest : public PacerTest {
 protected:
  PacedWorldTest() {
    read<topic::Location>(ground_);
    read<topic::NetworkQuality>(ground_);
    read<topic::NavigationStatus>(ground_);
  }
  ~PacedWorldTest() override { subscriptions_.clear(); }  // before the hosts go
  Network network_{core_, link_, QosProfiles(folder_.path("qos.yaml")), {}};
  SimHost uxv_{network_, "uxv", "uxv", config + "traffic.yaml"};
  SimHost gcs_{network_, "gcs", "gcs", config + "traffic.yaml"};
  SimProcess& drive_ = uxv_.add_process("drive");
  SimProcess& link_process_ = uxv_.add_process("link");
  SimProcess& ground_ = gcs_.add_process("ground");
};

TEST_F(PacedWorldTest, TheWritersOfAProcessShareTheBytesOfAPeriod) {
  write<topic::Location>(drive_);  // about 500 bytes
  write<topic::NetworkQuality>(drive_);
  EXPECT_EQ(link_.pushed(), 1U);
  run_until(0.0099);
  EXPECT_EQ(link_.pushed(), 1U);
  run_until(0.010);
  EXPECT_EQ(link_.pushed(), 2U);
  run_until(1);
  EXPECT_EQ(counter_.count, 2);
}

TEST_F(PacedWorldTest, EachProcessHasBytesOfItsOwn) {
  write<topic::Location>(drive_);
  write<topic::NetworkQuality>(link_process_);
  EXPECT_EQ(link_.pushed(), 2U);
}

TEST_F(PacedWorldTest, ProfilesWithoutAFlowControllerDoNotWait) {
  write<topic::Location>(drive_);
  const std::uint64_t before = link_.pushed();
  write<topic::NavigationStatus>(drive_);
  EXPECT_GT(link_.pushed(), before);
}

TEST(Pacer, CutsSamplesSoThatAPieceFitsAMessageAndAPeriod) {
  Core core;
  FlowController settings;
  settings.max_bytes_per_period = 5000;
  EXPECT_EQ(Pacer(core, settings).fragment_bytes(), 1224U);
  settings.max_bytes_per_period = 1399;
  EXPECT_EQ(Pacer(core, settings).fragment_bytes(), 1220U);
}

}  // namespace
}  // namespace tocsin::simulation
