// SPDX-License-Identifier: Apache-2.0
// Real ICMP, in network namespaces of the test's own, so that the machine's settings do not
// matter. Skipped where namespaces are not allowed.
#include "icmp_socket.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <net/if.h>
#include <netinet/in.h>
#include <poll.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cstring>
#include <fstream>
#include <functional>
#include <thread>
#include <utility>

#include "foundation/error.hpp"

namespace tocsin::network {
namespace {

void bring_loopback_up() {
  const int control = socket(AF_INET, SOCK_DGRAM, 0);
  ifreq request{};
  std::strncpy(request.ifr_name, "lo", IFNAMSIZ - 1);
  request.ifr_flags = IFF_UP;
  ASSERT_EQ(ioctl(control, SIOCSIFFLAGS, &request), 0);
  close(control);
}

/// Runs `body` in a new network namespace that lives as long as its thread.
void in_namespace(const std::function<void()>& body) {
  bool allowed = false;
  std::thread([&] {
    allowed = unshare(CLONE_NEWNET) == 0;
    if (allowed) body();
  }).join();
  if (!allowed) GTEST_SKIP() << "network namespaces are not allowed here";
}

void set(const std::string& name, const std::string& value) {
  std::ofstream("/proc/sys/net/ipv4/" + name) << value;  // of the calling thread's namespace
}

std::optional<EchoReply> wait_for_reply(IcmpSocket& socket) {
  const Time deadline = std::chrono::steady_clock::now() + std::chrono::seconds{5};
  while (std::chrono::steady_clock::now() < deadline) {
    pollfd wait{*socket.descriptor(), POLLIN, 0};
    (void)poll(&wait, 1, 200);
    if (const auto reply = socket.receive()) return reply;
  }
  return std::nullopt;
}

void expect_answers(IcmpSocket& sut) {
  for (std::uint16_t sequence = 0; sequence < 5; ++sequence) {
    const SendResult sent = sut.send(sequence);
    ASSERT_EQ(sent.error, 0);
    const auto reply = wait_for_reply(sut);
    ASSERT_TRUE(reply);
    EXPECT_EQ(reply->sequence, sequence);
    EXPECT_GE(reply->received_at, sent.at);
    EXPECT_LE(reply->received_at, std::chrono::steady_clock::now());
  }
  EXPECT_FALSE(sut.receive());
}

/// TOS bytes of the next request and its reply that a raw socket hears.
std::pair<int, int> tos_of_request_and_reply(int raw) {
  std::pair<int, int> tos{-1, -1};
  std::array<std::uint8_t, 256> packet{};
  for (int i = 0; i < 2; ++i) {
    pollfd wait{raw, POLLIN, 0};
    if (poll(&wait, 1, 5000) != 1 || recv(raw, packet.data(), packet.size(), 0) < 28) break;
    const bool is_request = packet[20] == 8;
    (is_request ? tos.first : tos.second) = packet[1];
  }
  return tos;
}

TEST(IcmpSocket, SendsRequestsWithItsDscpAndRepliesHaveTheSame) {
  in_namespace([] {
    bring_loopback_up();
    const int raw = socket(AF_INET, SOCK_RAW | SOCK_CLOEXEC, IPPROTO_ICMP);
    ASSERT_GE(raw, 0);
    IcmpSocket sut({"127.0.0.1", 64, 8});
    ASSERT_EQ(sut.send(1).error, 0);
    const auto [request, reply] = tos_of_request_and_reply(raw);
    EXPECT_EQ(request, 8 << 2);
    EXPECT_EQ(reply, 8 << 2);
    close(raw);
  });
}

TEST(IcmpSocket, IsADatagramSocketWhereTheGroupIsAllowedElseARawOneAndIsAnswered) {
  for (const auto& [range, is_raw] : {std::pair("0 2147483647", false), std::pair("1 0", true)}) {
    in_namespace([range = range, is_raw = is_raw] {
      bring_loopback_up();
      set("ping_group_range", range);
      IcmpSocket sut({"127.0.0.1", 64});
      EXPECT_EQ(sut.is_raw(), is_raw);
      expect_answers(sut);
    });
  }
}

TEST(IcmpSocket, DoesNotTakeTheRepliesOfAnotherSocket) {
  in_namespace([] {
    bring_loopback_up();
    IcmpSocket other({"127.0.0.1", 64});
    IcmpSocket sut({"127.0.0.1", 64});
    ASSERT_EQ(other.send(1).error, 0);
    ASSERT_TRUE(wait_for_reply(other));
    EXPECT_FALSE(sut.receive());
  });
}

TEST(IcmpSocket, TellsThatTheNetworkIsUnreachable) {
  in_namespace([] {  // nothing is up in here
    IcmpSocket sut({"192.0.2.1", 64});
    EXPECT_EQ(sut.send(1).error, ENETUNREACH);
    EXPECT_FALSE(sut.receive());
  });
}

TEST(IcmpSocket, WantsANumericIpv4Address) {
  for (const char* target : {"", "localhost", "::1", "1.2.3", "1.2.3.256"}) {
    EXPECT_THROW(IcmpSocket({target, 64}), ConfigError) << target;
  }
}

/// Runs `body` as an ordinary user without capabilities, in a child process.
TEST(IcmpSocket, SaysWhatItNeedsWhenItMayOpenNeitherKind) {
  if (geteuid() != 0) GTEST_SKIP() << "needs root, to give it up";
  const auto attempt = [] {
    if (unshare(CLONE_NEWNET) != 0) std::_Exit(3);
    set("ping_group_range", "1 0");
    if (setgid(65534) != 0 || setuid(65534) != 0) std::_Exit(3);
    try {
      IcmpSocket sut({"127.0.0.1", 64});
    } catch (const EnvironmentError& error) {
      std::fputs(error.what(), stderr);
      std::_Exit(1);
    }
    std::_Exit(0);
  };
  EXPECT_EXIT(attempt(), ::testing::ExitedWithCode(1), "ping_group_range.*CAP_NET_RAW");
}

}  // namespace
}  // namespace tocsin::network
