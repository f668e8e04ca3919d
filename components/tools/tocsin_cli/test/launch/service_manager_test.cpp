// SPDX-License-Identifier: Apache-2.0
#include "service_manager.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <string>

#include "foundation/temporary_folder.hpp"

namespace tocsin::cli {
namespace {

using std::chrono::seconds;

/// A socket as systemd has it, and the variables that name it.
class ServiceManagerTest : public ::testing::Test {
 protected:
  ~ServiceManagerTest() override {
    for (const char* name : {"NOTIFY_SOCKET", "WATCHDOG_USEC", "WATCHDOG_PID"}) ::unsetenv(name);
  }
  void listen(const std::string& name) {
    socket_ = FileDescriptor(::socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK, 0));
    sockaddr_un here{};
    here.sun_family = AF_UNIX;
    name.copy(here.sun_path, sizeof here.sun_path);
    if (name[0] == '@') here.sun_path[0] = '\0';
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
    ASSERT_EQ(::bind(socket_.get(), reinterpret_cast<const sockaddr*>(&here), size), 0);
    ::setenv("NOTIFY_SOCKET", name.c_str(), 1);
  }
  void watch(const std::string& microseconds, const std::string& process = "") {
    ::setenv("WATCHDOG_USEC", microseconds.c_str(), 1);
    if (!process.empty()) ::setenv("WATCHDOG_PID", process.c_str(), 1);
  }
  /// The next datagram, empty: there is none.
  [[nodiscard]] std::string heard() const {
    std::array<char, 256> text{};
    const auto size = ::recv(socket_.get(), text.data(), text.size(), 0);
    return {text.data(), size > 0 ? static_cast<std::size_t>(size) : 0};
  }

  const TemporaryFolder folder_;
  const Time start_ = Time{} + seconds(100);
  FileDescriptor socket_;
};

TEST_F(ServiceManagerTest, TellsWhenItIsReadyAndWhenItStops) {
  listen(folder_.path("notify"));
  ServiceManager sut;
  sut.ready("5 processes");
  EXPECT_EQ(heard(), "READY=1\nSTATUS=5 processes");
  sut.stopping();
  EXPECT_EQ(heard(), "STOPPING=1");
}

TEST_F(ServiceManagerTest, ReachesASocketWithoutAFile) {
  const std::string name = "@tocsin-notify-" + std::to_string(::getpid());
  listen(name);
  ServiceManager sut;
  sut.stopping();
  EXPECT_EQ(heard(), "STOPPING=1");
}

TEST_F(ServiceManagerTest, AnswersTheWatchdogTwiceInItsTime) {
  listen(folder_.path("notify"));
  watch("10000000", std::to_string(::getpid()));
  ServiceManager sut;
  sut.alive(start_);
  EXPECT_EQ(heard(), "WATCHDOG=1");
  EXPECT_EQ(sut.next_sign(), start_ + seconds(5));
  sut.alive(start_ + seconds(4));
  EXPECT_EQ(heard(), "");
  sut.alive(start_ + seconds(5));
  EXPECT_EQ(heard(), "WATCHDOG=1");
}

TEST_F(ServiceManagerTest, HasNoWatchdogThatIsAnothersOrNoNumber) {
  listen(folder_.path("notify"));
  watch("10000000", "1");
  EXPECT_EQ(ServiceManager().next_sign(), never);
  for (const char* text : {"", "0", "-5", "soon"}) {
    watch(text);
    EXPECT_EQ(ServiceManager().next_sign(), never) << text;
  }
}

TEST_F(ServiceManagerTest, ItsProcessesDoNotInheritTheVariables) {
  listen(folder_.path("notify"));
  watch("10000000", "1");
  const ServiceManager sut;
  for (const char* name : {"NOTIFY_SOCKET", "WATCHDOG_USEC", "WATCHDOG_PID"}) {
    EXPECT_EQ(std::getenv(name), nullptr) << name;
  }
}

TEST_F(ServiceManagerTest, WithoutOneItDoesNothing) {
  for (const std::string& address :
       {std::string(), std::string(200, 'a'), folder_.path("absent")}) {
    ::setenv("NOTIFY_SOCKET", address.c_str(), 1);
    ServiceManager sut;
    sut.ready("");
    sut.alive(start_);
    EXPECT_EQ(sut.next_sign(), never);
  }
}

}  // namespace
}  // namespace tocsin::cli
