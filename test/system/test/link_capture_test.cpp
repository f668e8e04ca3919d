// SPDX-License-Identifier: Apache-2.0
// Large datagrams of another participant in a real run over the emulated radio.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>

#include "crossing.hpp"
#include "fast_dds/fast_dds_participant.hpp"
#include "foundation/temporary_folder.hpp"
#include "idl_support/encode.hpp"
#include "link/flow_ends.hpp"
#include "link/raw_type.hpp"
#include "packet_tap.hpp"
#include "ros_idl/std_msgs.hpp"
#include "shared.hpp"

namespace tocsin {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using String = std_msgs::msg::String;

struct Largest : Receiver {
  void receive(const Sample& sample) override {
    bytes = std::max(bytes.load(), static_cast<const String*>(sample.message.get())->data().size());
  }
  std::atomic<std::size_t> bytes{0};
};

/// Writes a String of 8 kB over and over, each in one datagram.
void write_large(const std::string& topic) {
  FastDdsParticipant participant({"other", standing_domain + 2, "10.77.0.2", {"10.77.0.1"}});
  String message;
  message.data(std::string(8000, 'x'));
  const TypeInfo& type = type_info<String>();
  const auto encoded = std::make_shared<EncodedMessage>(EncodedMessage{encode(type, &message)});
  QosProfile profile;
  profile.reliability = Reliability::best_effort;
  FlowWriter writer(participant, topic, type.name, profile, [](const auto&) {});
  CarriedSample sample;
  sample.content = encoded;
  sample.bytes = static_cast<std::uint32_t>(encoded->bytes.size());
  for (sample.sequence = 1;; ++sample.sequence) {
    sample.sent_wall_ns = wall_now_ns();
    (void)writer.write(sample);
    std::this_thread::sleep_for(milliseconds(50));
  }
}

TEST(LinkCapture, ADatagramOfEightKilobytesFromAnotherParticipantArrives) {
  const TemporaryFolder folder;
  const Stack stack({standing_mission(folder.path()), "--seed", "1", "--without", "uxv/payload"});
  ASSERT_TRUE(Stack::eventually(seconds(30), [&] { return stack.pid("gcs/recorder") != 0; }));
  const PacketTap gcs(stack.pid("gcs/recorder"));
  if (!gcs.ok()) GTEST_SKIP() << "the namespaces cannot be entered";
  const Shared<Largest> arrived;
  const Peer reader(stack.pid("uxv/drive"), on_host(standing_domain), [&](Bus& bus) {
    const auto subscription =
        bus.subscribe({{"crossing/large", "sensor", Scope::host}, &type_info<String>()}, *arrived);
    for (;;) pause();
  });
  const Peer writer(stack.pid("gcs/recorder"), [] { write_large("rt/crossing/large"); });
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

}  // namespace
}  // namespace tocsin
