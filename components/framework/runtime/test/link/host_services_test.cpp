// SPDX-License-Identifier: Apache-2.0
// What a router does with services of a host whose types it does not know, by real UDP on loopback.
// Other makers' clients and servers: test/interop.
#include "runtime/middleware/host_services.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fast_dds/lamp_service.hpp"
#include "link/link_bus_fixture.hpp"
#include "qos/config_file.hpp"
#include "ros_idl/std_srvs.hpp"
#include "runtime/middleware/link_bus.hpp"

namespace tocsin {
namespace {

using Response = std_srvs::srv::SetBool_Response;
using Bytes = std::vector<std::uint8_t>;
using ::testing::ElementsAre;

const HostService raw_lamp{"lamp", "std_srvs/srv/SetBool"};
const ServiceEndpoint lamp = lamp_endpoint("lamp");
const Bytes yes{0, 1, 0, 0, 1};
/// success, then an empty text with its length.
const Bytes done{0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0};

/// Without what Fast DDS pads on the wire: up to three bytes behind the message.
Bytes cut_to(const Bytes& expected, Bytes message) {
  const std::size_t padded = (expected.size() + 3) / 4 * 4;
  if (message.size() == padded) message.resize(expected.size());
  return message;
}

class HostServicesTest : public LinkBusFixture {
 protected:
  HostServicesTest() : LinkBusFixture(221) {}
  [[nodiscard]] std::unique_ptr<LinkBus> router(const std::string& rules) {
    BusOptions with_rules = options(Role::uxv);
    file_ = std::make_unique<ConfigFile>(rules);
    with_rules.traffic_file = file_->path();
    return make_fast_dds_link_bus(with_rules, [] {});
  }
  /// The next event of this kind.
  template <class Event>
  static std::optional<Event> wait_for(HostServices& services) {
    std::optional<Event> found;
    (void)eventually([&] {
      while (const auto event = services.take()) {
        if (const auto* one = std::get_if<Event>(&*event)) {
          found = *one;
          return true;
        }
      }
      return false;
    });
    return found;
  }

 private:
  std::unique_ptr<ConfigFile> file_;
};

TEST_F(HostServicesTest, WithoutServicesInTheTrafficFileThereAreNone) {
  EXPECT_EQ(router("uxv: {high: {topics: [odom]}}\n")->services(), nullptr);
}

TEST_F(HostServicesTest, AServerOfTheHostIsKnownAskedAndItsReplyHasTheNumberOfTheRequest) {
  const auto bus = router("uxv: {high: {services: [lamp]}}\n");
  HostServices& sut = *bus->services();
  sut.call(raw_lamp);
  EXPECT_FALSE(sut.ask("lamp", yes)) << "nobody serves it";
  const auto host = process(Role::uxv);
  LampServer server(*host, lamp);
  const auto known = wait_for<host_service_event::Server>(sut);
  ASSERT_TRUE(known);
  EXPECT_EQ(known->what, raw_lamp);
  std::optional<std::int64_t> number;
  ASSERT_TRUE(eventually([&] { return (number = sut.ask("lamp", yes)).has_value(); }));
  std::optional<host_service_event::Reply> reply;
  ASSERT_TRUE(eventually([&] {
    server.answer();
    while (const auto event = sut.take()) {
      if (const auto* one = std::get_if<host_service_event::Reply>(&*event)) reply = *one;
    }
    return reply.has_value();
  }));
  EXPECT_EQ(reply->service, "lamp");
  EXPECT_EQ(reply->number, *number);
  EXPECT_EQ(cut_to(done, reply->message), done);
  sut.end_calling("lamp");
  EXPECT_FALSE(sut.ask("lamp", yes));
}

TEST_F(HostServicesTest, AClientOfTheHostIsKnownServedAndGetsItsReply) {
  const auto bus = router("uxv: {}\ngcs: {high: {services: [lamp]}}\n");
  HostServices& sut = *bus->services();
  const auto host = process(Role::uxv);
  LampClient client(*host, lamp);
  const auto known = wait_for<host_service_event::Client>(sut);
  ASSERT_TRUE(known);
  EXPECT_EQ(known->what, raw_lamp);
  EXPECT_FALSE(client.available());
  sut.serve(raw_lamp);
  std::optional<std::int64_t> number;
  ASSERT_TRUE(eventually([&] { return (number = client.ask(true)).has_value(); }));
  const auto request = wait_for<host_service_event::Request>(sut);
  ASSERT_TRUE(request);
  EXPECT_EQ(request->service, "lamp");
  EXPECT_EQ(cut_to(yes, request->message), yes);
  sut.reply("lamp", request->id, done);
  ASSERT_TRUE(eventually([&] {
    (void)sut.take();  // a reply waits for a client that cannot hear it yet
    return client.replies().size() == 1;
  }));
  EXPECT_EQ(client.replies()[0].number, *number);
  EXPECT_TRUE(std::static_pointer_cast<const Response>(client.replies()[0].message)->success());
  sut.end_serving("lamp");
  EXPECT_TRUE(eventually([&] { return !client.available(); }));
}

TEST_F(HostServicesTest, ATypeThatCanBeNoneIsALineInTheLogAndNothingElse) {
  const auto bus = router("uxv: {high: {services: [lamp]}}\n");
  HostServices& sut = *bus->services();
  sut.call({"lamp", "no type"});
  sut.serve({"lamp", "no type"});
  EXPECT_FALSE(sut.ask("lamp", yes));
}

}  // namespace
}  // namespace tocsin
