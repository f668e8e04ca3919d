// SPDX-License-Identifier: Apache-2.0
// /rosout as a peer of ROS 2 on the same host sees it: name, QoS, type hash and bytes.
#include "container/rosout.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <mutex>
#include <thread>

#include "idl_support/decode.hpp"
#include "runtime/host_control.hpp"
#include "runtime/logger.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"
#include "runtime/middleware/host_graph.hpp"

namespace tocsin {
namespace {

using Bytes = std::vector<std::uint8_t>;
constexpr int domain = 146;

BusOptions options(const char* name) {
  BusOptions options;
  options.name = name;
  options.host_domain = domain;
  options.ros_namespace = "uxv";
  return options;
}

class Owner : public Component {
 public:
  using Component::Component;
  void tick(Time) override {}
};

template <class Condition>
bool eventually(const Condition& condition) {
  for (int i = 0; i < 2000; ++i) {
    if (condition()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

const GraphEnd* writer_in(const std::vector<GraphEnd>& ends) {
  for (const GraphEnd& end : ends) {
    if (end.topic == "rt/rosout" && end.writer) return &end;
  }
  return nullptr;
}

/// The bytes behind the stamp: level, name, text.
const Bytes after_stamp{30,  0,   0,   0, 8, 0, 0, 0, 'u', 'x', 'v', '.',
                        'a', 'r', 'm', 0, 4, 0, 0, 0, 'h', 'o', 't', 0};
constexpr unsigned warned_in_line = __LINE__ + 1;
void warn() { Logger("left arm", "arm").warn("{}", "hot"); }

void expect_offer(const GraphEnd& end) {
  EXPECT_EQ(end.type, "rcl_interfaces::msg::dds_::Log_");
  EXPECT_EQ(end.qos.reliability, Reliability::reliable);
  EXPECT_EQ(end.qos.durability, Durability::transient_local);
  EXPECT_EQ(end.lifespan_s, 10);
  EXPECT_THAT(end.user_data, ::testing::HasSubstr("typehash=RIHS01_e28ce254"));
}

void expect_line(const Bytes& encoded) {
  const auto message = decode(type_info<RosoutTopic::Message>(), encoded);
  ASSERT_TRUE(message);
  const auto& log = *static_cast<const RosoutTopic::Message*>(message.get());
  EXPECT_EQ(log.file(), "rosout_test.cpp");
  EXPECT_EQ(log.function(), "warn");
  EXPECT_EQ(log.line(), warned_in_line);
}

TEST(Rosout, IsOfferedAsRos2DoesAndALateReaderReceivesTheLastLines) {
  const auto bus = make_fast_dds_bus(options("logging"));
  Context context = Context(*bus, "control", Role::uxv).with_node("drive_container");
  Owner owner(context);
  Rosout sut(owner);
  sut.serve({"arm"});
  bus->host_control().update_graph();
  warn();
  sut.tell();

  const auto peer = make_host_graph(options("peer"));
  ASSERT_TRUE(eventually([&] { return writer_in(peer->ends()) && peer->nodes().size() == 2; }));
  const auto ends = peer->ends();
  const GraphEnd& end = *writer_in(ends);
  expect_offer(end);
  for (const GraphNode& node : peer->nodes()) {
    EXPECT_THAT(node.writers, ::testing::Contains(end.gid)) << node.path();
  }

  std::mutex mutex;
  Bytes heard;
  const auto reading = peer->read({end.topic, end.type, true, true}, [&](RawSample&& sample) {
    const std::lock_guard<std::mutex> lock(mutex);
    heard = *sample.bytes;
  });
  ASSERT_TRUE(eventually([&] {
    const std::lock_guard<std::mutex> lock(mutex);
    return !heard.empty();
  }));
  ASSERT_GE(heard.size(), 12 + after_stamp.size());
  EXPECT_EQ(Bytes(heard.begin(), heard.begin() + 4), (Bytes{0, 1, 0, 0}));
  EXPECT_EQ(Bytes(heard.begin() + 12,
                  heard.begin() + 12 + static_cast<std::ptrdiff_t>(after_stamp.size())),
            after_stamp);
  expect_line(heard);
}

}  // namespace
}  // namespace tocsin
