// SPDX-License-Identifier: Apache-2.0
// Large datagrams of another participant in a real run over the emulated radio.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>

#include "crossing.hpp"
#include "foundation/temporary_folder.hpp"
#include "packet_tap.hpp"
#include "ros_idl/std_msgs.hpp"
#include "runtime/testing/large_writer.hpp"
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

TEST(LinkCapture, ADatagramOfEightKilobytesFromAnotherParticipantArrives) {
  const TemporaryFolder folder;
  const Stack stack({standing_mission(folder.path()), "--seed", "1", "--without", "uxv/payload"});
  ASSERT_TRUE(Stack::eventually(seconds(30), [&] { return stack.pid("gcs/recorder") != 0; }));
  const PacketTap gcs(stack.running("gcs/recorder"));
  if (!gcs.ok()) GTEST_SKIP() << "the namespaces cannot be entered";
  const Shared<Largest> arrived;
  const Peer reader(stack.running("uxv/drive"), on_host(standing_domain), [&](Bus& bus) {
    const auto subscription =
        bus.subscribe({{"crossing/large", "sensor", Scope::host}, &type_info<String>()}, *arrived);
    for (;;) pause();
  });
  const Peer writer(stack.running("gcs/recorder"), [] {
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

}  // namespace
}  // namespace tocsin
