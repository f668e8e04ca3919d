// SPDX-License-Identifier: Apache-2.0
// A topic of a type that nobody here knows, from Cyclone DDS on one host to Cyclone DDS on another,
// over the participants of two routers on real sockets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <mutex>

#include "cyclone.hpp"
#include "foundation/temporary_folder.hpp"
#include "headed_services.h"
#include "runtime/middleware/host_graph.hpp"
#include "runtime/testing/relay.hpp"
#include "within.hpp"

namespace tocsin::interop {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int vehicle = 225;
constexpr int station = 226;
const RawTopic never{"rt/robot/never", "nobody_msgs::msg::dds_::Never_", true, true};

BusOptions on(int domain) {
  BusOptions options;
  options.name = "host";
  options.host_domain = domain;
  return options;
}

BusOptions router(Role role, const std::string& traffic_file) {
  BusOptions options = on(role == Role::uxv ? vehicle : station);
  options.name = options.host = to_string(role);
  options.role = role;
  options.traffic_file = traffic_file;
  options.link_domain = 227;
  options.link_address = "127.0.0.1";
  options.link_peers = {"127.0.0.1"};
  return options;
}

/// One end of the topic, reliable and transient local.
class CycloneEnd {
 public:
  explicit CycloneEnd(int domain) : participant_(domain), qos_(CycloneParticipant::qos()) {
    dds_qset_reliability(qos_.get(), DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
    dds_qset_durability(qos_.get(), DDS_DURABILITY_TRANSIENT_LOCAL);
    topic_ = participant_.topic(headed_SetBoolResponse_desc, never.name, never.type);
  }
  [[nodiscard]] dds_entity_t writer() const { return participant_.writer(topic_, qos_); }
  [[nodiscard]] dds_entity_t reader() const { return participant_.reader(topic_, qos_); }

 private:
  CycloneParticipant participant_;
  CycloneParticipant::Qos qos_;
  dds_entity_t topic_ = 0;
};

/// The last message of the topic on a host, as it stands on the wire.
class LastBytes {
 public:
  explicit LastBytes(int domain)
      : graph_(make_host_graph(on(domain))),
        reading_(graph_->read(never, [this](RawSample&& sample) {
          const std::lock_guard<std::mutex> lock(mutex_);
          bytes_ = *sample.bytes;
        })) {}
  [[nodiscard]] Bytes get() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return bytes_;
  }

 private:
  std::mutex mutex_;
  Bytes bytes_;
  std::unique_ptr<HostGraph> graph_;
  std::unique_ptr<RawReading> reading_;
};

TEST(RoutedTopics, ATypeThatNobodyKnowsArrivesByteForByteAndWithTheQosOfItsWriter) {
  const TemporaryFolder folder;
  const std::string rules =
      folder.write("traffic.yaml", "uxv: {low: {topics: ['robot/*']}}\ngcs: {}\n");
  const Relay uxv(router(Role::uxv, rules));
  const Relay gcs(router(Role::gcs, rules));
  LastBytes here(vehicle);
  LastBytes there(station);
  const CycloneEnd robot(vehicle);
  const dds_entity_t writer = robot.writer();
  std::string text = "what no interface file of this workspace says";
  const headed_SetBoolResponse message{0x0123456789ABCDEF, -5, true, text.data()};
  ASSERT_TRUE(eventually([&] {
    (void)dds_write(writer, &message);
    return !here.get().empty() && !there.get().empty();
  }));
  EXPECT_EQ(there.get(), here.get());

  const CycloneEnd tool(station);  // it comes late, and asks for the last one
  const dds_entity_t reader = tool.reader();
  std::string heard;
  EXPECT_TRUE(eventually([&] {
    void* sample = nullptr;
    dds_sample_info_t info{};
    if (dds_take(reader, &sample, &info, 1, 1) != 1) return false;
    const auto& one = *static_cast<const headed_SetBoolResponse*>(sample);
    EXPECT_EQ(one.client, message.client);
    EXPECT_EQ(one.number, message.number);
    heard = one.message;
    (void)dds_return_loan(reader, &sample, 1);
    return true;
  }));
  EXPECT_EQ(heard, text);
}

}  // namespace
}  // namespace tocsin::interop
