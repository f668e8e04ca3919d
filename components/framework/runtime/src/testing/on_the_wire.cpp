// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <thread>

#include "fast_dds/fast_dds_participant.hpp"
#include "idl_support/encode.hpp"
#include "idl_support/raw_type.hpp"
#include "link/flow_ends.hpp"
#include "ros_idl/std_msgs.hpp"
#include "rtps/this_host.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "runtime/testing/kernel.hpp"
#include "runtime/testing/large_writer.hpp"
#include "transport/udp_sockets.hpp"

namespace tocsin {

bool kernel_tells_users() { return UdpSockets().answers(); }

void write_large(const LargeWriter& writer, std::size_t bytes, Duration period) {
  using String = std_msgs::msg::String;
  FastDdsParticipant participant({"other", writer.domain, writer.address, {writer.peer}});
  String message;
  message.data(std::string(bytes, 'x'));
  const TypeInfo& type = type_info<String>();
  const auto encoded = std::make_shared<EncodedMessage>(EncodedMessage{encode(type, &message)});
  QosProfile profile;
  profile.reliability = Reliability::best_effort;
  FlowWriter flow(participant, writer.topic, type.name, profile, [](const auto&, bool) {});
  CarriedSample sample;
  sample.content = encoded;
  sample.bytes = static_cast<std::uint32_t>(encoded->bytes.size());
  for (sample.sequence = 1;; ++sample.sequence) {
    sample.sent_wall_ns = wall_now_ns();
    (void)flow.write(sample);
    std::this_thread::sleep_for(period);
  }
}

}  // namespace tocsin
