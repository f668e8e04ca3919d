// SPDX-License-Identifier: Apache-2.0
// Who is on a host and what they say, of whatever type, by real UDP on loopback.
#include "runtime/middleware/host_graph.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "fast_dds/bus_fixture.hpp"
#include "graph/ros_graph.hpp"
#include "idl_support/encode.hpp"
#include "ros_idl/std_msgs.hpp"
#include "runtime/host_control.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;
using String = std_msgs::msg::String;

const char* const qos =
    "state: {reliability: reliable, durability: transient_local, depth: 1, lifespan_s: 60}\n"
    "event: {reliability: reliable, depth: 10}\n";
const Endpoint state{{"state", "state", Scope::host}, &type_info<String>()};
const Endpoint event{{"event", "event", Scope::host}, &type_info<String>()};
const RawTopic raw_state{"rt/state", "std_msgs::msg::dds_::String_", true, true};
const RawTopic raw_event{"rt/event", "std_msgs::msg::dds_::String_", true, false};

std::vector<std::uint8_t> encoded(const std::string& data) {
  String message;
  message.data(data);
  return encode(type_info<String>(), &message);
}

std::shared_ptr<const String> text(const std::string& data) {
  auto made = std::make_shared<String>();
  made->data(data);
  return made;
}

class HostGraphTest : public ::testing::Test {
 protected:
  HostGraphTest() : domain_(next_domain()), graph_(make_host_graph(options())) {}

  [[nodiscard]] BusOptions options() const {
    BusOptions options;
    options.name = "graph";
    options.host_domain = domain_;
    return options;
  }
  [[nodiscard]] std::unique_ptr<Bus> process() const { return make_test_bus(domain_, qos); }
  /// Null: it is not there.
  [[nodiscard]] std::optional<GraphEnd> end_of(const std::string& topic, bool writer) const {
    for (const GraphEnd& one : graph_->ends()) {
      if (one.topic == topic && one.writer == writer) return one;
    }
    return std::nullopt;
  }
  void take(RawSample&& sample) {
    const std::lock_guard<std::mutex> lock(mutex_);
    samples_.push_back(std::move(sample));
  }
  [[nodiscard]] std::vector<RawSample> taken() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return samples_;
  }
  [[nodiscard]] std::unique_ptr<RawReading> read(const RawTopic& topic) {
    return graph_->read(topic, [this](RawSample&& sample) { take(std::move(sample)); });
  }

 private:
  static int next_domain() {
    static int next = 50;
    return ++next;
  }
  const int domain_;
  std::mutex mutex_;
  std::vector<RawSample> samples_;

 protected:
  std::unique_ptr<HostGraph> graph_;
};

TEST_F(HostGraphTest, KnowsTheEndsOfOthersWithWhatTheyOfferUntilTheyLeave) {
  const auto bus = process();
  auto writer = bus->advertise(state);
  ASSERT_TRUE(eventually([&] { return end_of("rt/state", true).has_value(); }));
  const GraphEnd end = *end_of("rt/state", true);
  EXPECT_EQ(end.type, "std_msgs::msg::dds_::String_");
  EXPECT_EQ(end.participant, "test");
  EXPECT_EQ(text_of(end.gid).substr(0, 5), "01.0f");  // eProsima's
  EXPECT_EQ(end.qos.reliability, Reliability::reliable);
  EXPECT_EQ(end.qos.durability, Durability::transient_local);
  EXPECT_EQ(end.lifespan_s, 60);
  EXPECT_THAT(end.user_data, HasSubstr("tocsinlayout="));
  EXPECT_THAT(end.user_data, HasSubstr(std::string("typehash=") + state.type->ros_hash + ";"));
  EXPECT_FALSE(end_of("rt/state", false));
  writer.reset();
  EXPECT_TRUE(eventually([&] { return !end_of("rt/state", true); }));
}

TEST_F(HostGraphTest, KnowsTheNodesOfAProcessWithTheirEndsUntilItLeaves) {
  auto bus = process();
  Samples unread;
  Endpoint of_talker = state;
  of_talker.node = "talker";
  Endpoint of_both = event;
  auto writer = bus->advertise(of_talker);
  of_both.node = "talker";
  auto reader = bus->subscribe(of_both, unread);
  of_both.node = "listener";
  auto other_reader = bus->subscribe(of_both, unread);
  bus->host_control().update_graph();
  ASSERT_TRUE(eventually([&] { return graph_->nodes().size() == 2 && end_of("rt/event", false); }));
  const auto nodes = graph_->nodes();
  EXPECT_EQ(nodes[0].path(), "/listener");
  EXPECT_EQ(nodes[0].readers, std::vector<Gid>{end_of("rt/event", false)->gid});
  EXPECT_EQ(nodes[1].path(), "/talker");
  EXPECT_EQ(nodes[1].readers, nodes[0].readers);  // neighbours share it
  EXPECT_EQ(nodes[1].writers, std::vector<Gid>{end_of("rt/state", true)->gid});
  other_reader.reset();
  bus->host_control().update_graph();
  EXPECT_TRUE(eventually([&] { return graph_->nodes().size() == 1; }));
  reader.reset();
  writer.reset();
  bus.reset();
  EXPECT_TRUE(eventually([&] { return graph_->nodes().empty(); }));
}

// A reader as of Humble announces no type hash; one as of Iron does.
TEST_F(HostGraphTest, GidsHaveTheSizeThatThePeersTake) {
  const auto peer = make_host_graph(options());
  const RawTopic as_humble{discovery_topic, discovery_type, true, true};
  const auto bus = process();
  Endpoint of_talker = state;
  of_talker.node = "talker";
  const auto writer = bus->advertise(of_talker);
  bus->host_control().update_graph();
  std::mutex mutex;
  std::size_t bytes = 0;
  const auto reading = peer->read(as_humble, [&](RawSample&& sample) {
    const std::lock_guard<std::mutex> lock(mutex);
    bytes = sample.bytes->size();
  });
  const ParticipantNodes told{{}, {{"/", "talker", {}, {Gid{}}}}};
  EXPECT_TRUE(eventually([&] {
    bus->host_control().update_graph();
    const std::lock_guard<std::mutex> lock(mutex);
    return bytes == encode(told, GidSize::bytes_24).size();
  }));
}

TEST_F(HostGraphTest, ReadsTheLastSampleOfAStateAsBytes) {
  const auto bus = process();
  const auto writer = bus->advertise(state);
  ASSERT_EQ(writer->write(text("on")), Status::ok);
  const auto reading = read(raw_state);
  ASSERT_TRUE(eventually([&] { return !taken().empty(); }));
  const RawSample sample = taken().front();
  String message;
  ASSERT_TRUE(
      type_info<String>().deserialize(sample.bytes->data(), sample.bytes->size(), &message));
  EXPECT_EQ(message.data(), "on");
  EXPECT_GT(sample.sent_wall_ns, 0);
  EXPECT_EQ(sample.sequence, 1U);
}

TEST_F(HostGraphTest, HearsNothingMoreWhenTheReadingIsGone) {
  const auto bus = process();
  const auto writer = bus->advertise(event);
  auto reading = read(raw_event);
  ASSERT_TRUE(eventually([&] {
    (void)writer->write(text("again"));
    return !taken().empty();
  }));
  reading.reset();
  const std::size_t before = taken().size();
  for (int i = 0; i < 20; ++i) (void)writer->write(text("unheard"));
  EXPECT_TRUE(eventually([&] { return !end_of("rt/event", false); }));
  EXPECT_EQ(taken().size(), before);
}

TEST_F(HostGraphTest, WritesToOrdinaryReadersAndCountsThem) {
  const auto bus = process();
  Samples heard;
  const auto reader = bus->subscribe(event, heard);
  const auto writing = graph_->write(raw_event);
  ASSERT_TRUE(eventually([&] { return writing->readers() == 1; }));
  EXPECT_TRUE(writing->write(encoded("hello")));
  ASSERT_TRUE(heard.wait_for(1));
  EXPECT_EQ(std::static_pointer_cast<const String>(heard.all().front().message)->data(), "hello");
}

TEST_F(HostGraphTest, OffersTheQosThatItIsGiven) {
  const auto observer = make_host_graph(options());
  QosProfile offered;
  offered.reliability = Reliability::best_effort;
  offered.deadline_s = 2;
  offered.lifespan_s = 5;
  const auto writing = graph_->write(raw_event, offered);
  std::optional<GraphEnd> seen;
  ASSERT_TRUE(eventually([&] {
    for (const GraphEnd& one : observer->ends()) {
      if (one.topic == raw_event.name) seen = one;
    }
    return seen.has_value();
  }));
  const GraphEnd& end = *seen;
  EXPECT_EQ(end.qos.reliability, Reliability::best_effort);
  EXPECT_EQ(end.qos.durability, Durability::volatile_kind);
  EXPECT_EQ(end.qos.deadline_s, 2);
  EXPECT_EQ(end.lifespan_s, 5);
}

TEST(Readable, IsReliableWithTheLastSamplesWhereAllWritersOfferIt) {
  GraphEnd mode;
  mode.topic = "rt/mode";
  mode.type = "std_msgs::msg::dds_::String_";
  mode.qos.reliability = Reliability::reliable;
  mode.qos.durability = Durability::transient_local;
  GraphEnd events = mode;
  events.type = "another";
  events.qos.durability = Durability::volatile_kind;
  GraphEnd stream = events;
  stream.qos.reliability = Reliability::best_effort;
  const RawTopic of_mode = readable({&mode, &mode});
  EXPECT_EQ(of_mode.name, "rt/mode");
  EXPECT_EQ(of_mode.type, "std_msgs::msg::dds_::String_");
  EXPECT_TRUE(of_mode.reliable);
  EXPECT_TRUE(of_mode.transient_local);
  EXPECT_TRUE(readable({&mode, &events}).reliable);
  EXPECT_FALSE(readable({&mode, &events}).transient_local);
  EXPECT_EQ(readable({&mode, &events}).type, "std_msgs::msg::dds_::String_");
  stream.qos.durability = Durability::transient_local;  // which it cannot keep: it repairs nothing
  EXPECT_FALSE(readable({&mode, &stream}).reliable);
  EXPECT_FALSE(readable({&stream}).transient_local);
}

TEST_F(HostGraphTest, OfABusHearsThatBusAndItsNeighbours) {
  const auto near = process();
  const auto far = process();
  const auto publication = near->advertise(event);
  const auto other = far->advertise(state);
  const auto graph = near->host_control().open_graph();
  ASSERT_NE(graph, nullptr);
  EXPECT_TRUE(eventually([&] {
    const auto ends = graph->ends();
    const auto has = [&](const char* topic) {
      return std::any_of(ends.begin(), ends.end(),
                         [&](const GraphEnd& end) { return end.topic == topic && end.writer; });
    };
    return has("rt/event") && has("rt/state");
  }));
}

TEST(OpenHostGraph, ThereIsNoneOfABusWithoutADomain) {
  SimBus bus;
  EXPECT_EQ(bus.host_control().open_graph(), nullptr);
}

}  // namespace
}  // namespace tocsin
