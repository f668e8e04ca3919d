// SPDX-License-Identifier: Apache-2.0
// Real sockets on loopback.
#include "fast_dds_v2/deferred_reception.hpp"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <atomic>

#include "fast_dds/bus_fixture.hpp"
#include "transport/guarded_transport.hpp"
#include "transport/packet_filter.hpp"
#include "watch/dropped_packets.hpp"

namespace tocsin {
namespace {

namespace rtps = eprosima::fastdds::rtps;
using namespace eprosima::fastdds::rtps;

constexpr std::uint16_t port = 27'391;
const std::string header_only("RTPS\2\1\1\17sender_prefi", 20);

class CountingReceiver : public TransportReceiverInterface {
 public:
  void OnDataReceived(const rtps::octet*, const std::uint32_t, const rtps::Locator_t&,
                      const rtps::Locator_t&) override {
    ++heard;
  }
  std::atomic<int> heard{0};
};

class DeferredReceptionTest : public ::testing::Test {
 protected:
  DeferredReceptionTest() {
    auto udp = std::make_shared<UDPv4TransportDescriptor>();
    udp->interfaceWhiteList = {"127.0.0.1"};
    auto filter = std::make_shared<PacketFilter>(rtps_filter::Limits{});
    transport_.reset(
        guarded_transport({udp, nullptr, reception_, std::move(filter)})->create_transport());
    at_.kind = LOCATOR_KIND_UDPv4;
    at_.port = port;
    rtps::IPLocator::setIPv4(at_, "127.0.0.1");
  }
  ~DeferredReceptionTest() override { transport_->CloseInputChannel(at_); }
  void SetUp() override {
    ASSERT_TRUE(transport_->init());
    ASSERT_TRUE(transport_->OpenInputChannel(at_, &receiver_, 1000));
  }
  static void send(const std::string& bytes = header_only) {
    const int fd = socket(AF_INET, SOCK_DGRAM, 0);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(sendto(fd, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&to),
                     sizeof to),
              static_cast<ssize_t>(bytes.size()));
    close(fd);
  }
  std::shared_ptr<DeferredReception> reception_ = std::make_shared<DeferredReception>();
  CountingReceiver receiver_;
  rtps::Locator_t at_;
  std::unique_ptr<TransportInterface> transport_;
};

TEST_F(DeferredReceptionTest, WhatArrivesBeforeTheReleaseIsHeardAfterIt) {
  send();
  send();
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(receiver_.heard, 0);
  reception_->release();
  EXPECT_TRUE(eventually([this] { return receiver_.heard == 2; }));
}

TEST_F(DeferredReceptionTest, WhatArrivesAfterTheReleaseIsHeardAtOnce) {
  reception_->release();
  send();
  EXPECT_TRUE(eventually([this] { return receiver_.heard == 1; }));
}

TEST_F(DeferredReceptionTest, WhatIsNoRtpsIsNotShownButCounted) {
  reception_->release();
  const auto before = dropped_packets();
  send("garbage");
  send();
  EXPECT_TRUE(eventually([this] { return receiver_.heard == 1; }));
  const auto dropped = dropped_packets().since(before);
  EXPECT_EQ(dropped.total(), 1U);
  EXPECT_EQ(dropped.by_source().begin()->first, INADDR_LOOPBACK);
  EXPECT_EQ(dropped.count(rtps_filter::DropReason::not_rtps), 1U);
}

TEST_F(DeferredReceptionTest, AChannelThatIsClosedBeforeTheReleaseDoesNotHang) {
  send();
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_TRUE(transport_->CloseInputChannel(at_));
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::milliseconds(900));
}

}  // namespace
}  // namespace tocsin
