// SPDX-License-Identifier: Apache-2.0
// What both routers put on wlan0 in real runs over the emulated radio.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <new>
#include <optional>
#include <set>

#include "crossing.hpp"
#include "foundation/temporary_folder.hpp"
#include "packet_tap.hpp"
#include "ros_idl/std_msgs.hpp"
#include "runtime/middleware/link_permissions.hpp"
#include "runtime/testing/large_writer.hpp"
#include "sent_packets.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using ::testing::Contains;
using String = std_msgs::msg::String;

constexpr int discovery_dscp = 48;
/// IP and UDP headers, and the largest RTPS message of a router.
constexpr std::size_t largest_packet = 28 + 1400;

/// The class of a topic of the link; nothing for one that is not to cross.
std::optional<TrafficClass> class_of(const std::string& topic, const TrafficRules& rules) {
  if (topic == link_acknowledgement_topic) return TrafficClass::critical;
  if (topic == link_services_topic) return TrafficClass::high;
  const TrafficRule* const rule = rules.find(topic);
  return rule == nullptr ? std::nullopt : std::optional(rule->traffic_class);
}

/// Classes of what was sent; each packet is checked on the way.
std::set<TrafficClass> check_marks(const std::vector<Sent>& packets, const TrafficRules& rules) {
  std::set<TrafficClass> seen;
  for (const Sent& one : packets) {
    EXPECT_LE(one.bytes, largest_packet) << one.topic;
    if (one.discovery) {
      EXPECT_EQ(one.dscp, discovery_dscp);
      continue;
    }
    const auto expected = class_of(one.topic, rules);
    if (!expected) {
      ADD_FAILURE() << "a packet of '" << one.topic << "', which is not to cross";
      continue;
    }
    EXPECT_EQ(one.dscp, rules.dscp(*expected)) << one.topic;
    EXPECT_THAT((std::set<int>{0x15, 0x16}), Contains(one.kind)) << one.topic;  // DATA, DATA_FRAG
    seen.insert(*expected);
  }
  return seen;
}

TEST(LinkCapture, EachPacketOfAMissionBearsTheMarkOfItsClassAndNoneIsAbove1400Bytes) {
  Stack stack({"mission.yaml", "--seed", "1", "--without", "gcs/view"});
  ASSERT_TRUE(Stack::eventually(seconds(30), [&] { return stack.pid("gcs/mission") != 0; }));
  const PacketTap uxv(stack.pid("uxv/drive"));
  const PacketTap gcs(stack.pid("gcs/recorder"));
  if (!uxv.ok() || !gcs.ok()) GTEST_SKIP() << "the namespaces cannot be entered";
  // What a writer's topic is crosses when routers meet, which may have been before the taps.
  std::this_thread::sleep_for(seconds(1));
  const std::int64_t since = wall_now_ns();
  ASSERT_EQ(kill(stack.pid("uxv/link"), SIGKILL), 0);
  ASSERT_EQ(kill(stack.pid("gcs/link"), SIGKILL), 0);
  const TrafficRules uxv_rules(stack.share("config/traffic.yaml"), Role::uxv);
  const TrafficRules gcs_rules(stack.share("config/traffic.yaml"), Role::gcs);
  const auto topics = [&](const PacketTap& tap) {
    std::set<std::string> names;
    for (const Sent& one : sent(tap, since)) names.insert(one.topic);
    return names;
  };
  const auto has = [](const std::set<std::string>& names, const std::set<std::string>& wanted) {
    return std::includes(names.begin(), names.end(), wanted.begin(), wanted.end());
  };
  ASSERT_TRUE(Stack::eventually(seconds(40), [&] {
    return has(topics(uxv), {"camera/image_raw/compressed", "heartbeat", "link_acknowledgement",
                             "link_state", "location"}) &&
           has(topics(gcs), {"heartbeat", "link_acknowledgement", "link_state"});
  })) << stack.output();
  EXPECT_EQ(check_marks(sent(uxv, since), uxv_rules).size(), 4U) << "classes of the vehicle";
  EXPECT_GE(check_marks(sent(gcs, since), gcs_rules).size(), 2U) << "classes of the station";
}

/// Memory that this process and its peers share.
template <class T>
class Shared {
 public:
  Shared()
      : memory_(
            mmap(nullptr, sizeof(T), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    if (memory_ == MAP_FAILED) throw std::runtime_error("no shared memory");
    new (memory_) T;
  }
  ~Shared() { munmap(memory_, sizeof(T)); }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;
  T* operator->() const { return static_cast<T*>(memory_); }

 private:
  void* memory_;
};

BusOptions on_vehicle() {
  BusOptions options;
  options.name = "peer";
  options.host_domain = standing_domain;
  return options;
}

struct Largest : Receiver {
  void receive(const Sample& sample) override {
    bytes = std::max(bytes.load(), static_cast<const String*>(sample.message.get())->data().size());
  }
  std::atomic<std::size_t> bytes{0};
};

TEST(LinkCapture, ADatagramOfEightKilobytesFromAnotherParticipantArrives) {
  const TemporaryFolder folder;
  const Stack stack({standing_mission(folder.path()), "--seed", "1", "--without", "uxv/payload"});
  ASSERT_TRUE(Stack::eventually(seconds(30), [&] { return stack.pid("gcs/recorder") != 0; }));
  const PacketTap gcs(stack.pid("gcs/recorder"));
  if (!gcs.ok()) GTEST_SKIP() << "the namespaces cannot be entered";
  const Shared<Largest> arrived;
  const Peer reader(stack.pid("uxv/drive"), on_vehicle(), [&](Bus& bus) {
    const auto subscription = bus.subscribe(
        {{"crossing/large", "sensor", Scope::host}, &type_info<String>()}, *arrived.operator->());
    for (;;) pause();
  });
  const Peer writer(stack.pid("gcs/recorder"), [] {
    write_large({standing_domain + 2, "10.77.0.2", "10.77.0.1", "rt/crossing/large"}, 8000,
                milliseconds(50));
  });
  ASSERT_TRUE(Stack::eventually(seconds(20), [&] { return arrived->bytes == 8000; }))
      << stack.output();
  const auto packets = gcs.packets();
  const bool in_ip_fragments =
      std::any_of(packets.begin(), packets.end(), [](const TappedPacket& packet) {
        constexpr std::uint8_t more_fragments = 0x20;
        return packet.outgoing && (packet.bytes[6] & more_fragments) != 0;
      });
  EXPECT_TRUE(in_ip_fragments) << "it was not one datagram";
}

/// Says five times a second whether the vehicle may send.
void tell_state(Bus& bus, const std::atomic<bool>& active) {
  const auto writer = bus.advertise(
      {topic::TransmissionState::info, &type_info<topic::TransmissionState::Message>()});
  for (;;) {
    const auto message = std::make_shared<topic::TransmissionState::Message>();
    message->role("uxv");
    message->active(active);
    (void)writer->write(message);
    std::this_thread::sleep_for(milliseconds(200));
  }
}

/// Writes to the vehicle's topics of every class, five times a second: 60 kB/s, for which the link
/// has room also where a busy computer makes it look slow.
void write_all_classes(Bus& bus) {
  std::vector<std::unique_ptr<Publication>> writers;
  for (const char* const name : {"crossing/up", "crossing/latest", "crossing/image"}) {
    writers.push_back(bus.advertise({{name, "sensor", Scope::host}, &type_info<String>()}));
  }
  const auto message = std::make_shared<String>();
  message->data(std::string(4000, 'x'));
  for (;;) {
    for (const auto& writer : writers) (void)writer->write(message);
    std::this_thread::sleep_for(milliseconds(200));
  }
}

/// A mission in which the test is the vehicle's transmission_controller.
const std::string without_controller =
    "  uxv:\n    containers:\n      - name: link\n        components:\n"
    "          - transmission_controller: ~\n";
constexpr std::int64_t half_s = 500'000'000;

/// What of both pausable topics was sent since then.
std::size_t pausable(const PacketTap& tap, std::int64_t since_ns) {
  const auto packets = sent(tap, 0);
  return count(packets, "crossing/latest", since_ns) + count(packets, "crossing/image", since_ns);
}

/// For five seconds nothing of the pausable topics is sent, and class critical goes on.
void expect_silence(const PacketTap& tap, std::int64_t paused) {
  std::this_thread::sleep_for(seconds(5));
  const auto during = sent(tap, 0);
  EXPECT_EQ(count(during, "crossing/latest", paused), 0U);
  EXPECT_EQ(count(during, "crossing/image", paused), 0U);
  EXPECT_GT(count(during, "crossing/up", paused), 20U) << "class critical is not paused";
}

TEST(LinkCapture, APausedFlowIsSilentOnTheWireForFiveSecondsAndResumesWithoutDiscovery) {
  const TemporaryFolder folder;
  const Stack stack({standing_mission(folder.path(), without_controller), "--seed", "1",
                     "--without", "uxv/payload"});
  ASSERT_TRUE(Stack::eventually(seconds(30), [&] { return stack.pid("gcs/recorder") != 0; }))
      << stack.output();
  const PacketTap uxv(stack.pid("uxv/drive"));
  if (!uxv.ok()) GTEST_SKIP() << "the namespaces cannot be entered";
  const Shared<std::atomic<bool>> active;
  active->store(true);
  const pid_t there = stack.pid("uxv/drive");
  const Peer controller(there, on_vehicle(),
                        [&](Bus& bus) { tell_state(bus, *active.operator->()); });
  const Peer writer(there, on_vehicle(), write_all_classes);
  const auto crosses_after = [&](std::int64_t since_ns) {
    return Stack::eventually(seconds(20), [&] {
      const auto packets = sent(uxv, 0);
      return count(packets, "crossing/latest", since_ns) > 0 &&
             count(packets, "crossing/image", since_ns) > 0;
    });
  };
  ASSERT_TRUE(crosses_after(0)) << stack.output();
  const auto all_is_discovered = [&] { return announcements(uxv, wall_now_ns() - half_s) == 0; };
  ASSERT_TRUE(Stack::eventually(seconds(20), all_is_discovered));

  active->store(false);
  const auto is_silent = [&] { return pausable(uxv, wall_now_ns() - half_s) == 0; };
  ASSERT_TRUE(Stack::eventually(seconds(20), is_silent));
  const std::int64_t paused = wall_now_ns();
  expect_silence(uxv, paused);

  const std::int64_t resumed = wall_now_ns();
  active->store(true);
  ASSERT_TRUE(crosses_after(resumed)) << stack.output();
  for (const Sent& one : sent(uxv, 0)) {
    if (one.time_ns <= paused || one.discovery) continue;
    EXPECT_NE(one.kind, 0x07) << "a heartbeat of " << one.topic;
  }
  EXPECT_EQ(announcements(uxv, paused), 0U);
}

}  // namespace
}  // namespace tocsin
