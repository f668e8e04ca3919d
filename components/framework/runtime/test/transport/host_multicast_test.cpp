// SPDX-License-Identifier: Apache-2.0
// Real sockets; another computer is a network namespace at the end of a virtual cable.
#include "transport/host_multicast.hpp"

#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <linux/if_packet.h>
#include <net/ethernet.h>
#include <net/if.h>
#include <sched.h>
#include <sys/socket.h>
#include <sys/syscall.h>

#include <cstdlib>
#include <future>
#include <mutex>
#include <optional>
#include <set>

#include "fast_dds/bus_fixture.hpp"
#include "foundation/error.hpp"
#include "transport/udp_sockets.hpp"

namespace tocsin {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr std::uint16_t port = 27'400;

in_addr address_of(const char* text) {
  in_addr address{};
  inet_pton(AF_INET, text, &address);
  return address;
}

sockaddr_in at(const char* address, std::uint16_t its_port) {
  sockaddr_in where{};
  where.sin_family = AF_INET;
  where.sin_port = htons(its_port);
  where.sin_addr = address_of(address);
  return where;
}

/// A socket that multicasts on the interface with this address.
FileDescriptor socket_on(const char* address) {
  FileDescriptor sender(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  const in_addr interface = address_of(address);
  setsockopt(sender.get(), IPPROTO_IP, IP_MULTICAST_IF, &interface, sizeof interface);
  return sender;
}

void send(const FileDescriptor& from, const std::string& text, const sockaddr_in& to) {
  (void)sendto(from.get(), text.data(), text.size(), 0, reinterpret_cast<const sockaddr*>(&to),
               sizeof to);
}

/// What a program of another vendor does: joins the group on the interface of its choice.
FileDescriptor member_on(const char* address) {
  FileDescriptor member(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const int one = 1;
  setsockopt(member.get(), SOL_SOCKET, SO_REUSEADDR, &one, sizeof one);
  const sockaddr_in any = at("0.0.0.0", port);
  EXPECT_EQ(bind(member.get(), reinterpret_cast<const sockaddr*>(&any), sizeof any), 0);
  const ip_mreq group{address_of(discovery_group), address_of(address)};
  EXPECT_EQ(setsockopt(member.get(), IPPROTO_IP, IP_ADD_MEMBERSHIP, &group, sizeof group), 0);
  return member;
}

std::optional<std::string> received(const FileDescriptor& socket) {
  std::array<char, 100> bytes{};
  const ssize_t size = recv(socket.get(), bytes.data(), bytes.size(), MSG_DONTWAIT);
  if (size < 0) return std::nullopt;
  return std::string(bytes.data(), static_cast<std::size_t>(size));
}

/// A network namespace with `eth1`, 10.9.1.2, at a cable whose end here is `eth0`, 10.9.1.1.
class OtherComputer {
 public:
  OtherComputer() {
    std::promise<void> done;
    thread_ = std::thread([this, &done] {
      make();
      done.set_value();
      leave_.get_future().wait();
    });
    done.get_future().wait();
  }
  ~OtherComputer() {
    leave_.set_value();
    thread_.join();
    (void)!system("ip link delete eth0 2>/dev/null");
  }
  OtherComputer(const OtherComputer&) = delete;
  OtherComputer& operator=(const OtherComputer&) = delete;

  [[nodiscard]] bool is_there() const { return is_there_; }
  /// Sends from there.
  [[nodiscard]] const FileDescriptor& sender() const { return sender_; }
  /// The texts of UDP that came there from here.
  [[nodiscard]] std::vector<std::string> heard() const {
    std::vector<std::string> texts;
    constexpr std::size_t headers = 28;
    while (const auto packet = received(tap_)) {
      if (packet->size() > headers && (*packet)[9] == IPPROTO_UDP) {
        texts.push_back(packet->substr(headers));
      }
    }
    return texts;
  }

 private:
  void make() {
    const std::string here = "/proc/" + std::to_string(getpid()) + "/ns/net";
    if (unshare(CLONE_NEWNET) != 0) return;
    const std::string tid = std::to_string(syscall(SYS_gettid));
    is_there_ = system(("ip link set lo up && nsenter --net=" + here +
                        " ip link add eth0 type veth peer name eth1 netns " + tid +
                        " && nsenter --net=" + here +
                        " sh -c 'ip address add 10.9.1.1/24 dev eth0 "
                        "&& ip link set eth0 up' && ip address add 10.9.1.2/24 dev eth1 && ip link "
                        "set eth1 up")
                           .c_str()) == 0;
    if (!is_there_) return;
    sender_ = socket_on("10.9.1.2");
    tap_.reset(socket(AF_PACKET, SOCK_DGRAM | SOCK_CLOEXEC, htons(ETH_P_IP)));
    sockaddr_ll cable{};
    cable.sll_family = AF_PACKET;
    cable.sll_protocol = htons(ETH_P_IP);
    cable.sll_ifindex = static_cast<int>(if_nametoindex("eth1"));
    is_there_ = bind(tap_.get(), reinterpret_cast<const sockaddr*>(&cable), sizeof cable) == 0;
  }
  bool is_there_ = false;
  FileDescriptor sender_;
  FileDescriptor tap_;
  std::promise<void> leave_;
  std::thread thread_;
};

class HostMulticastTest : public ::testing::Test {
 protected:
  HostMulticastTest() {
    receiver_.start([this](const std::uint8_t* bytes, std::size_t size, const sockaddr_in&) {
      const std::lock_guard<std::mutex> lock(mutex_);
      heard_.emplace_back(bytes, bytes + size);
    });
  }
  /// Each text once: a datagram may come by several interfaces.
  [[nodiscard]] std::set<std::string> heard() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return {heard_.begin(), heard_.end()};
  }
  [[nodiscard]] bool hears(const std::string& text) {
    return eventually([&] { return heard().count(text) > 0; });
  }
  std::mutex mutex_;
  std::vector<std::string> heard_;
  HostMulticastReceiver receiver_{port};
};

TEST_F(HostMulticastTest, HearsWhatAProgramSendsOnLoopback) {
  send(socket_on("127.0.0.1"), "hello", at(discovery_group, port));
  EXPECT_TRUE(hears("hello"));
}

TEST_F(HostMulticastTest, HearsWhatAProgramSendsOnAnInterfaceThatItHasJoined) {
  const OtherComputer other;
  if (!other.is_there()) GTEST_SKIP() << "no right to make network namespaces";
  const FileDescriptor member = member_on("10.9.1.1");
  send(socket_on("10.9.1.1"), "hello", at(discovery_group, port));
  EXPECT_TRUE(hears("hello"));
}

TEST_F(HostMulticastTest, DoesNotHearAnotherComputerThatAProgramOfThisHostHears) {
  const OtherComputer other;
  if (!other.is_there()) GTEST_SKIP() << "no right to make network namespaces";
  const FileDescriptor member = member_on("10.9.1.1");
  std::optional<std::string> text;
  ASSERT_TRUE(eventually([&] {  // the cable takes a moment to come up
    send(other.sender(), "far", at(discovery_group, port));
    text = received(member);
    return text.has_value();
  }));
  EXPECT_EQ(text, "far");
  send(socket_on("10.9.1.1"), "near", at(discovery_group, port));
  ASSERT_TRUE(hears("near"));
  EXPECT_THAT(heard(), ElementsAre("near"));
}

TEST_F(HostMulticastTest, ReachesAProgramOnItsInterfaceAndNobodyBeyond) {
  const OtherComputer other;
  if (!other.is_there()) GTEST_SKIP() << "no right to make network namespaces";
  const FileDescriptor member = member_on("10.9.1.1");
  const FileDescriptor from = sole_udp_socket();
  HostMulticastSender sut(from);
  const std::string hello = "hello";
  std::optional<std::string> text;
  ASSERT_TRUE(eventually([&] {
    sut.send(reinterpret_cast<const std::uint8_t*>(hello.data()), hello.size(), port);
    text = received(member);
    return text.has_value();
  }));
  EXPECT_EQ(text, hello);
  std::vector<std::string> far;
  ASSERT_TRUE(eventually([&] {  // the cable takes a moment to come up
    send(socket_on("10.9.1.1"), "last", at(discovery_group, port));  // time to live 1: it leaves
    for (std::string& one : other.heard()) far.push_back(std::move(one));
    return !far.empty();
  }));
  EXPECT_THAT(far, Each("last"));
}

/// The port that a datagram came from; 0: none has come.
std::uint16_t sender_of(const FileDescriptor& socket) {
  std::array<char, 100> bytes{};
  sockaddr_in sender{};
  socklen_t size = sizeof sender;
  const ssize_t got = recvfrom(socket.get(), bytes.data(), bytes.size(), MSG_DONTWAIT,
                               reinterpret_cast<sockaddr*>(&sender), &size);
  return got < 0 ? std::uint16_t{0} : ntohs(sender.sin_port);
}

// Peers take announcements of one participant from its own ports only.
TEST_F(HostMulticastTest, SendsByEachInterfaceFromThePortOfItsSocket) {
  const OtherComputer other;
  if (!other.is_there()) GTEST_SKIP() << "no right to make network namespaces";
  const FileDescriptor member = member_on("10.9.1.1");
  const FileDescriptor from = sole_udp_socket();
  sockaddr_in own{};
  socklen_t size = sizeof own;
  ASSERT_EQ(getsockname(from.get(), reinterpret_cast<sockaddr*>(&own), &size), 0);
  HostMulticastSender sut(from);
  std::uint16_t sender = 0;
  ASSERT_TRUE(eventually([&] {
    const std::uint8_t byte = 'x';
    sut.send(&byte, 1, port);
    sender = sender_of(member);
    return sender != 0;
  }));
  EXPECT_EQ(sender, ntohs(own.sin_port));
}

TEST_F(HostMulticastTest, SendsNothingWhereNobodyIsAMember) {
  const OtherComputer other;
  if (!other.is_there()) GTEST_SKIP() << "no right to make network namespaces";
  const FileDescriptor from = sole_udp_socket();
  HostMulticastSender sut(from);
  const std::uint8_t byte = 'x';
  sut.send(&byte, 1, port);
  std::vector<std::string> far;
  ASSERT_TRUE(eventually([&] {
    send(socket_on("10.9.1.1"), "last", at(discovery_group, port));
    for (std::string& one : other.heard()) far.push_back(std::move(one));
    return !far.empty();
  }));
  EXPECT_EQ(far.front(), "last");
}

TEST_F(HostMulticastTest, StopEndsAThreadThatHearsNothing) {
  receiver_.stop();
  EXPECT_FALSE(receiver_.is_running());
}

TEST(HostMulticastPort, OneThatAnotherProgramKeepsForItselfIsAnErrorThatNamesIt) {
  const FileDescriptor other(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
  const sockaddr_in any = at("0.0.0.0", port + 1);
  ASSERT_EQ(bind(other.get(), reinterpret_cast<const sockaddr*>(&any), sizeof any), 0);
  try {
    const HostMulticastReceiver sut(port + 1);
    FAIL();
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("239.255.0.1:27401"));
  }
}

TEST(HostMulticastMembers, AreReadFromTheKernelsTableWithoutLoopback) {
  const std::string table =
      "Idx\tDevice    : Count Querier\tGroup    Users Timer\tReporter\n"
      "1\tlo        :     2      V3\n"
      "\t\t\t\t0100FFEF     1 0:00000000\t\t0\n"
      "\t\t\t\t010000E0     1 0:00000000\t\t0\n"
      "3\teth0      :     2      V3\n"
      "\t\t\t\t0100FFEF     1 0:00000000\t\t0\n"
      "4\twlan0     :     1      V3\n"
      "\t\t\t\t010000E0     1 0:00000000\t\t0\n";
  EXPECT_THAT(interfaces_with_member(table, address_of(discovery_group), 1), ElementsAre(3U));
  EXPECT_THAT(interfaces_with_member(table, address_of("239.255.0.2"), 1), IsEmpty());
  EXPECT_THAT(interfaces_with_member("", address_of(discovery_group), 1), IsEmpty());
}

}  // namespace
}  // namespace tocsin
