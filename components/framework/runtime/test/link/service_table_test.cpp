// SPDX-License-Identifier: Apache-2.0
#include "link/service_table.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

using namespace host_service_event;

class ServiceTableTest : public ::testing::Test {
 protected:
  static ServiceTable::Guid guid(std::uint8_t participant) {
    ServiceTable::Guid guid;
    guid.guidPrefix.value[3] = participant;
    return guid;
  }
  static AnnouncedEnd writer(const std::string& topic, const std::string& half) {
    AnnouncedEnd end;
    end.topic = topic;
    end.type = "std_srvs::srv::dds_::Trigger_" + half + "_";
    end.writer = true;
    return end;
  }
  template <class Event>
  Event next() {
    const auto event = sut_.pop();
    if (!event || !std::holds_alternative<Event>(*event)) {
      ADD_FAILURE() << "another event, or none";
      return {};
    }
    return std::get<Event>(*event);
  }

  int woken_ = 0;
  ServiceTable sut_{"uxv", [this] { ++woken_; }};
};

TEST_F(ServiceTableTest, AWriterOfRepliesIsAServerAndOneOfRequestsAClient) {
  sut_.on_end(guid(1), writer("rr/uxv/dockReply", "Response"), true);
  const auto server = next<Server>();
  EXPECT_TRUE(server.there);
  EXPECT_EQ(server.what, (HostService{"dock", "std_srvs/srv/Trigger"}));
  sut_.on_end(guid(2), writer("rq/uxv/dockRequest", "Request"), true);
  const auto client = next<Client>();
  EXPECT_TRUE(client.there);
  EXPECT_EQ(client.what, server.what);
  EXPECT_EQ(woken_, 2);
}

TEST_F(ServiceTableTest, AServerIsGoneWithTheLastOfItsName) {
  sut_.on_end(guid(1), writer("rr/uxv/dockReply", "Response"), true);
  sut_.on_end(guid(1), writer("rr/uxv/dockReply", "Response"), true);
  sut_.on_end(guid(2), writer("rr/uxv/dockReply", "Response"), true);
  (void)next<Server>();
  sut_.on_end(guid(1), writer("rr/uxv/dockReply", "Response"), false);
  EXPECT_FALSE(sut_.pop());
  sut_.on_end(guid(2), writer("rr/uxv/dockReply", "Response"), false);
  EXPECT_FALSE(next<Server>().there);
  sut_.on_end(guid(2), writer("rr/uxv/dockReply", "Response"), false);
  EXPECT_FALSE(sut_.pop());
}

TEST_F(ServiceTableTest, TopicsReadersAndOtherNamespacesAreNoServices) {
  sut_.on_end(guid(1), writer("rt/uxv/odom", "x"), true);
  sut_.on_end(guid(2), writer("rr/gcs/dockReply", "Response"), true);
  AnnouncedEnd reader = writer("rq/uxv/dockRequest", "Request");
  reader.writer = false;
  sut_.on_end(guid(3), reader, true);
  EXPECT_FALSE(sut_.pop());
  EXPECT_EQ(woken_, 0);
}

TEST_F(ServiceTableTest, OfMessagesThatNobodyTakesTheFirst1024AreKept) {
  for (int i = 0; i < 2000; ++i) sut_.push(Reply{"dock", i, {}});
  sut_.push(Changed{"dock"});
  for (int i = 0; i < 1024; ++i) EXPECT_EQ(next<Reply>().number, i);
  (void)next<Changed>();
  EXPECT_FALSE(sut_.pop());
}

}  // namespace
}  // namespace tocsin
