// SPDX-License-Identifier: Apache-2.0
// Real sockets on loopback.
#include "transport/host_side.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>

#include <future>

#include "fast_dds/bus_fixture.hpp"
#include "foundation/file_descriptor.hpp"
#include "runtime/fast_dds/transport.hpp"
#include "transport/host_multicast.hpp"
#include "transport/packet_filter.hpp"

namespace tocsin {
namespace {

namespace rtps = eprosima::fastdds::rtps;
using namespace eprosima::fastdds::rtps;
using ::testing::ElementsAre;
using ::testing::UnorderedElementsAre;

constexpr int domain = 44;
constexpr int group_port = discovery_group_port(domain);
constexpr int discovery_port = group_port + 30;  // even, as RTPS numbers them
constexpr int data_port = group_port + 31;
const std::string rtps_start("RTPS\2\1\1\17", 8);

rtps::Locator_t locator(const std::string& address, int port) {
  rtps::Locator_t made;
  made.kind = LOCATOR_KIND_UDPv4;
  made.port = static_cast<std::uint32_t>(port);
  rtps::IPLocator::setIPv4(made, address);
  return made;
}

/// Notes what comes; on the word "wait" it waits until it is let go.
class Listener : public TransportReceiverInterface {
 public:
  void OnDataReceived(const rtps::octet* bytes, const std::uint32_t size, const rtps::Locator_t&,
                      const rtps::Locator_t&) override {
    std::string text(bytes + rtps_start.size(), bytes + size);
    text.erase(text.find_last_not_of(' ') + 1);
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      texts_.push_back(text);
    }
    if (text == "wait") go_on_.get_future().wait();
  }
  [[nodiscard]] std::vector<std::string> texts() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return texts_;
  }
  void let_go() { go_on_.set_value(); }

 private:
  std::mutex mutex_;
  std::vector<std::string> texts_;
  std::promise<void> go_on_;
};

class HostSideTest : public ::testing::Test {
 protected:
  HostSideTest() : sut_(transport()) {
    EXPECT_TRUE(sut_->init());
    for (const auto& at : places_) {
      EXPECT_FALSE(sut_->IsInputChannelOpen(at));
      EXPECT_TRUE(sut_->OpenInputChannel(at, &listener_, 65'000));
      EXPECT_TRUE(sut_->IsInputChannelOpen(at));
    }
  }
  ~HostSideTest() override {
    for (const auto& at : places_) EXPECT_TRUE(sut_->CloseInputChannel(at));
  }
  static std::unique_ptr<TransportInterface> transport() {
    auto udp = std::make_shared<UDPv4TransportDescriptor>();
    udp->interfaceWhiteList = {"127.0.0.1"};
    auto reception = std::make_shared<DeferredReception>();
    reception->release();
    auto filter = std::make_shared<PacketFilter>(rtps_filter::Limits{});
    return std::unique_ptr<TransportInterface>(
        guarded_transport({udp, host_side(domain, 1U << 20U), reception, std::move(filter)})
            ->create_transport());
  }
  /// In a message of RTPS that has a header only, as the name of its sender.
  static void send(const std::string& sender_name, const std::string& address, int port) {
    const std::string text = (rtps_start + sender_name + "            ").substr(0, 20);
    const FileDescriptor sender(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
    const in_addr loopback{htonl(INADDR_LOOPBACK)};
    setsockopt(sender.get(), IPPROTO_IP, IP_MULTICAST_IF, &loopback, sizeof loopback);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(port));
    inet_pton(AF_INET, address.c_str(), &to.sin_addr);
    EXPECT_EQ(sendto(sender.get(), text.data(), text.size(), 0,
                     reinterpret_cast<const sockaddr*>(&to), sizeof to),
              static_cast<ssize_t>(text.size()));
  }
  /// "address:port", or "refused".
  [[nodiscard]] std::string taken_for(const std::string& address, int port) const {
    rtps::Locator_t result;
    if (!sut_->transform_remote_locator(locator(address, port), result)) return "refused";
    return rtps::IPLocator::toIPv4string(result) + ":" + std::to_string(result.port);
  }
  const std::vector<rtps::Locator_t> places_{locator(discovery_group, group_port),
                                             locator("127.0.0.1", discovery_port),
                                             locator("127.0.0.1", data_port)};
  Listener listener_;
  std::unique_ptr<TransportInterface> sut_;
};

TEST_F(HostSideTest, HearsTheGroupAndUnicast) {
  send("group", discovery_group, group_port);
  send("discovery", "127.0.0.1", discovery_port);
  send("data", "127.0.0.1", data_port);
  EXPECT_TRUE(eventually([&] { return listener_.texts().size() == 3; }));
  EXPECT_THAT(listener_.texts(), UnorderedElementsAre("group", "discovery", "data"));
}

// While Fast DDS answers an announcement, it throws away what else its sender says.
TEST_F(HostSideTest, WhatFollowsAnAnnouncementWaitsUntilThatIsDealtWithAndSamplesDoNot) {
  send("wait", discovery_group, group_port);
  ASSERT_TRUE(eventually([&] { return listener_.texts().size() == 1; }));
  send("discovery", "127.0.0.1", discovery_port);
  send("data", "127.0.0.1", data_port);
  ASSERT_TRUE(eventually([&] { return listener_.texts().size() == 2; }));
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_THAT(listener_.texts(), ElementsAre("wait", "data"));
  listener_.let_go();
  EXPECT_TRUE(eventually([&] { return listener_.texts().size() == 3; }));
}

TEST_F(HostSideTest, SendsToEveryPeerByLoopback) {
  EXPECT_EQ(taken_for("127.0.0.1", 7412), "127.0.0.1:7412");
  EXPECT_EQ(taken_for("192.168.7.9", 7412), "127.0.0.1:7412");
}

TEST_F(HostSideTest, SendsNothingButAnnouncementsByMulticast) {
  EXPECT_EQ(taken_for(discovery_group, group_port),
            std::string(discovery_group) + ":" + std::to_string(group_port));
  EXPECT_EQ(taken_for(discovery_group, group_port + 1), "refused") << "Cyclone DDS's, for samples";
  EXPECT_EQ(taken_for("239.255.0.7", group_port), "refused");
}

TEST_F(HostSideTest, KnowsNothingOfOtherKinds) {
  rtps::Locator_t shared_memory;
  shared_memory.kind = LOCATOR_KIND_SHM;
  rtps::Locator_t result;
  EXPECT_FALSE(sut_->transform_remote_locator(shared_memory, result));
}

TEST_F(HostSideTest, OneChannelSendsToAllPeersAndAnnounces) {
  SendResourceList channels;
  for (const char* const address : {"127.0.0.1", "192.168.7.9", "127.0.0.1"}) {
    EXPECT_TRUE(sut_->OpenOutputChannel(channels, locator(address, 7412)));
  }
  EXPECT_EQ(channels.size(), 1U);
}

}  // namespace
}  // namespace tocsin
