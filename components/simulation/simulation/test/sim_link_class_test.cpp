// SPDX-License-Identifier: Apache-2.0
// With which priority routers of simulated hosts send, and what observers see of it.
#include <gtest/gtest.h>

#include "link_bus_fixture.hpp"

namespace tocsin::simulation {
namespace {

/// Keeps what it is shown.
class LinkWatch : public Observer {
 public:
  using Category = radio::AccessCategory;
  void on_channel(const radio::LinkReport& report, Time) override { report_ = report; }
  void on_written(const Written& one) override { written.push_back(one); }
  void on_sent(const Sent& one) override { sent.push_back(one); }
  void on_delivered(const Delivered& one) override { delivered.push_back(one); }
  void on_gate(const GateChange& change) override { gates.push_back(change.event); }
  [[nodiscard]] std::uint64_t up(Category category) const {
    return report_.uplink.categories[static_cast<std::size_t>(category)].pushed;
  }
  [[nodiscard]] std::uint64_t down(Category category) const {
    return report_.downlink.categories[static_cast<std::size_t>(category)].pushed;
  }
  std::vector<Written> written;
  std::vector<Sent> sent;
  std::vector<Delivered> delivered;
  std::vector<GateEvent> gates;

 private:
  radio::LinkReport report_{};
};

/// The same hosts near the access point of a real radio.
class LinkClassTest : public ::testing::Test {
 protected:
  static radio::ChannelParams near_by(bool access_categories) {
    radio::ChannelParams params;
    params.access_categories = access_categories;
    return params;
  }
  /// One radio, its hosts and routers.
  struct World {
    explicit World(bool access_categories) : link(core, near_by(access_categories), {{}, 1, 1}) {
      core.observers = {&watch};
    }
    void run_for(double s) {
      const Time end = core.now + seconds(s);
      const auto next = [this] { return std::min(core.events.next(), link.next_event()); };
      for (Time at = next(); at <= end; at = next()) {
        core.now = std::max(core.now, at);
        core.events.run(core.now);
        link.advance();
        up.work();
        down.work();
      }
      core.now = end;
    }
    LinkWatch watch;
    Core core;
    RadioLink link;
    Network network{core, link, QosProfiles(TOCSIN_REPOSITORY "/config/qos.yaml")};
    SimHost uxv{network, "uxv", Role::uxv, TOCSIN_REPOSITORY "/config/traffic.yaml"};
    SimHost gcs{network, "gcs", Role::gcs, TOCSIN_REPOSITORY "/config/traffic.yaml"};
    SimProcess& payload = uxv.add_process("payload");
    SimProcess& view = gcs.add_process("view");
    PlainRouter up{network, uxv};
    PlainRouter down{network, gcs};
  };
};

TEST_F(LinkClassTest, PacketsCarryTheDscpOfTheirTopicsClass) {
  using Category = LinkWatch::Category;
  World world(true);
  const auto critical = world.payload.advertise(endpoint<topic::Heartbeat>());
  const auto high = world.payload.advertise(endpoint<topic::Location>());
  const auto normal = world.payload.advertise(endpoint<topic::TrafficReport>());
  const auto low = world.payload.advertise(endpoint<topic::BatteryState>());
  world.run_for(0.5);
  for (int i = 0; i < 3; ++i) (void)critical->write(message<topic::Heartbeat>());
  for (int i = 0; i < 5; ++i) (void)high->write(message<topic::Location>());
  for (int i = 0; i < 7; ++i) (void)normal->write(message<topic::TrafficReport>());
  for (int i = 0; i < 9; ++i) (void)low->write(message<topic::BatteryState>());
  world.up.work();
  world.run_for(2);
  EXPECT_EQ(world.watch.up(Category::video), 5U);
  EXPECT_EQ(world.watch.up(Category::best_effort), 7U);
  EXPECT_EQ(world.watch.up(Category::background), 9U);
  const std::uint64_t announced = world.watch.up(Category::voice) - 3;
  EXPECT_GE(announced, 1U);
  EXPECT_LE(announced, 3U);
  EXPECT_EQ(world.watch.down(Category::voice), announced);
  EXPECT_EQ(world.watch.down(Category::best_effort), 0U);
}

/// What is delivered when a heartbeat is written just after a picture.
std::vector<std::string> arrivals(LinkWatch& watch) {
  std::vector<std::string> topics;
  for (const Delivered& one : watch.delivered) topics.push_back(one.from.topic);
  return topics;
}

TEST_F(LinkClassTest, ACriticalSampleOvertakesAPictureWithAccessCategoriesOnly) {
  for (const bool access_categories : {true, false}) {
    World world(access_categories);
    Reader image;
    Reader beat;
    const auto reads_image = world.view.subscribe(endpoint<topic::CameraImage>(), image);
    const auto reads_beat = world.view.subscribe(endpoint<topic::Heartbeat>(), beat);
    const auto low = world.payload.advertise(endpoint<topic::CameraImage>());
    const auto critical = world.payload.advertise(endpoint<topic::Heartbeat>());
    world.run_for(0.5);
    (void)low->write(picture(40000));
    (void)critical->write(message<topic::Heartbeat>());
    world.up.work();
    world.run_for(1);
    const std::string camera = topic::CameraImage::info.name;
    const std::string heartbeat = topic::Heartbeat::info.name;
    EXPECT_EQ(arrivals(world.watch), access_categories
                                         ? (std::vector<std::string>{heartbeat, camera})
                                         : (std::vector<std::string>{camera, heartbeat}));
  }
}

TEST_F(LinkBusTest, ObserversSeeASampleFromItsWritingToItsDelivery) {
  LinkWatch watch;
  connect();
  read<topic::Location>(mission_);
  read<topic::Odom>(view_);
  const auto writer = drive_.advertise(endpoint<topic::Location>());
  run_for(1);
  core_.observers = {&watch};
  const Time written = core_.now;
  (void)writer->write(message<topic::Location>());
  run_for(0.001);
  ASSERT_EQ(watch.written.size(), 1U);
  EXPECT_EQ(watch.written[0].from.traffic_class, TrafficClass::high);
  EXPECT_GT(watch.written[0].bytes, 0U);
  ASSERT_EQ(watch.sent.size(), 1U);
  EXPECT_EQ(watch.sent[0].sequence, 1U);
  EXPECT_EQ(watch.sent[0].written, 1U);
  EXPECT_EQ(watch.sent[0].bytes, watch.written[0].bytes);
  EXPECT_TRUE(watch.delivered.empty());
  run_for(1);
  ASSERT_EQ(watch.delivered.size(), 1U);  // view does not read it
  const Delivered& one = watch.delivered[0];
  EXPECT_EQ(&one.from, &watch.written[0].from);
  EXPECT_EQ(one.to.process, "mission");
  EXPECT_EQ(one.written, 1U);
  EXPECT_EQ(one.written_at, written);
  EXPECT_EQ(one.received, written + seconds(0.01));
  core_.observers = {nullptr};
}

TEST_F(LinkBusTest, ObserversSeeEachTransmissionAndOneDelivery) {
  LinkWatch watch;
  connect();
  read<topic::Location>(mission_);
  const auto writer = drive_.advertise(endpoint<topic::Location>());
  run_for(1);
  core_.observers = {&watch};
  (void)writer->write(message<topic::Location>());
  run_for(1);
  const CarriedSample again = up().got<link_event::HostSample>()[0].sample;
  EXPECT_EQ(up().bus.send(up().opened.begin()->second, again, {}, 0), 2U);
  run_for(1);
  ASSERT_EQ(watch.sent.size(), 2U);
  EXPECT_EQ(watch.sent[1].sequence, 2U);
  EXPECT_EQ(watch.sent[1].written, 1U);
  EXPECT_EQ(watch.delivered.size(), 1U);
  core_.observers = {nullptr};
}

TEST_F(LinkBusTest, ObserversSeeTheGateOfARouterAndItsEndAndNotWhatItTellsAnother) {
  LinkWatch watch;
  connect();
  core_.observers = {&watch};
  up().bus.on_gate(false);
  up().bus.on_gate(true);
  const auto told = up().bus.pack(type_info<topic::Goal::Message>(), message<topic::Goal>());
  EXPECT_EQ(up().bus.send(up().bus.open({}, TrafficClass::critical), told, {}, 0), 1U);
  kill_router(uxv_);
  EXPECT_TRUE(watch.sent.empty());
  EXPECT_EQ(watch.gates,
            (std::vector<GateEvent>{GateEvent::closed, GateEvent::opened, GateEvent::gone}));
  core_.observers = {nullptr};
}

}  // namespace
}  // namespace tocsin::simulation
