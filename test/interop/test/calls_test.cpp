// SPDX-License-Identifier: Apache-2.0
// Clients and servers of rmw_fastrtps and rmw_cyclonedds on two hosts whose routers carry their
// calls: each hears what it would hear from a neighbour of its own make.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <map>
#include <optional>

#include "foundation/temporary_folder.hpp"
#include "lamp_service.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "within.hpp"

namespace tocsin::interop {
namespace {

using ::testing::ElementsAre;

const HostService lamp{"lamp/set", "std_srvs/srv/SetBool"};

/// Without what the makers pad on the wire: up to three bytes behind the message, and their number
/// in the fourth (DDS-XTypes 1.3, section 7.6.3.1.2).
Bytes cut_to(const Bytes& expected, Bytes message) {
  const std::size_t padded = (expected.size() + 3) / 4 * 4;
  if (message.size() == padded) message.resize(expected.size());
  if (message.size() > 3) message[3] = 0;
  return message;
}

/// Two hosts, and what their routers do with a call, without a link in between.
class Calls : public ::testing::Test {
 protected:
  static constexpr int vehicle = 218;
  static constexpr int station = 219;

  Calls() {
    station_services().serve(lamp);
    vehicle_services().call(lamp);
  }
  [[nodiscard]] std::unique_ptr<LinkBus> router(Role role, int domain) {
    BusOptions options;
    options.name = options.host = to_string(role);
    options.role = role;
    options.traffic_file =
        folder_.write("traffic.yaml", "uxv: {high: {services: [lamp/set]}}\ngcs: {}\n");
    options.host_domain = domain;
    options.link_domain = 220;
    options.link_address = "127.0.0.1";
    options.link_peers = {"127.0.0.1"};
    return make_fast_dds_link_bus(options, [] {});
  }
  HostServices& station_services() { return *station_->services(); }
  HostServices& vehicle_services() { return *vehicle_->services(); }

  void carry() {
    while (const auto event = station_services().take()) {
      const auto* request = std::get_if<host_service_event::Request>(&*event);
      if (request != nullptr) waiting_.push_back(*request);
    }
    for (; !waiting_.empty(); waiting_.pop_front()) {
      const auto number = vehicle_services().ask(lamp.name, waiting_.front().message);
      if (!number) break;
      asked_[*number] = waiting_.front().id;
    }
    while (const auto event = vehicle_services().take()) {
      const auto* reply = std::get_if<host_service_event::Reply>(&*event);
      if (reply != nullptr) {
        station_services().reply(reply->service, asked_.at(reply->number), reply->message);
      }
    }
  }
  /// Clients of both makers ask, and each gets the replies to its own requests only.
  template <class Serve>
  void expect_both_answered(FastDdsService& fast, CycloneClient& cyclone, const Serve& serve) {
    FastDdsService::Identity asked;
    asked.writer_guid(fast.reader_guid());
    const std::int64_t number = fast.write(request_bytes, asked);
    cyclone.write({0x1122334455667788, 42, true});
    std::vector<std::int64_t> of_fast;
    std::vector<std::int64_t> of_cyclone;
    ASSERT_TRUE(eventually([&] {
      carry();
      serve();
      while (const auto reply = fast.take()) {
        if (reply->related.writer_guid() != fast.reader_guid()) continue;  // as rmw_fastrtps
        EXPECT_EQ(cut_to(response_bytes, reply->bytes), response_bytes);
        of_fast.push_back(reply->related.sequence_number().to64long());
      }
      cyclone.take([&](const headed_SetBoolResponse& reply) {
        if (reply.client != 0x1122334455667788) return;  // as rmw_cyclonedds
        EXPECT_TRUE(reply.success);
        EXPECT_STREQ(reply.message, "on");
        of_cyclone.push_back(reply.number);
      });
      return !of_fast.empty() && !of_cyclone.empty();
    }));
    EXPECT_THAT(of_fast, ElementsAre(number));
    EXPECT_THAT(of_cyclone, ElementsAre(42));
  }

 private:
  const TemporaryFolder folder_;
  const std::unique_ptr<LinkBus> vehicle_ = router(Role::uxv, vehicle);
  const std::unique_ptr<LinkBus> station_ = router(Role::gcs, station);
  std::deque<host_service_event::Request> waiting_;  ///< for the server
  std::map<std::int64_t, CallId> asked_;
};

TEST_F(Calls, AServerOfRmwFastrtpsAnswersClientsOfBothMakersOnAnotherHost) {
  FastDdsService server(vehicle, replies, requests);
  FastDdsService fast(station, requests, replies);
  CycloneClient cyclone(station);
  ASSERT_TRUE(eventually(
      [&] { return server.is_connected() && fast.is_connected() && cyclone.is_connected(); }));
  expect_both_answered(fast, cyclone, [&] {
    while (const auto request = server.take()) {
      EXPECT_EQ(cut_to(request_bytes, request->bytes), request_bytes);
      FastDdsService::Identity answered = request->related;
      answered.sequence_number(request->identity.sequence_number());
      (void)server.write(response_bytes, answered);
    }
  });
}

TEST_F(Calls, AServerOfRmwCycloneddsAnswersClientsOfBothMakersOnAnotherHost) {
  CycloneServer server(vehicle);
  FastDdsService fast(station, requests, replies);
  CycloneClient cyclone(station);
  ASSERT_TRUE(eventually(
      [&] { return server.is_connected() && fast.is_connected() && cyclone.is_connected(); }));
  std::string text = "on";
  expect_both_answered(fast, cyclone, [&] {
    server.take([&](const headed_SetBoolRequest& request) {
      EXPECT_TRUE(request.data);
      server.write({request.client, request.number, true, text.data()});
    });
  });
}

}  // namespace
}  // namespace tocsin::interop
