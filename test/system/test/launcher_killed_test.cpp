// SPDX-License-Identifier: Apache-2.0
// What stops the vehicle when its launcher is killed, which takes all its processes with it. The
// base is outside of the launch, as a real one is, and tells its position ten times a second.
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string>

#include "foundation/file_descriptor.hpp"
#include "foundation/temporary_folder.hpp"
#include "operator_process.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;
using std::chrono::seconds;

struct Position {
  double x = 0;
  double y = 0;
};

double between(const Position& one, const Position& other) {
  return std::hypot(one.x - other.x, one.y - other.y);
}

/// Hears where the base is.
class PositionFeed {
 public:
  explicit PositionFeed(const std::string& path) : socket_(::socket(AF_UNIX, SOCK_DGRAM, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::strncpy(address.sun_path, path.c_str(), sizeof address.sun_path - 1);
    const timeval patience{2, 0};
    ::setsockopt(socket_.get(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    EXPECT_EQ(::bind(socket_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0)
        << std::strerror(errno);
  }
  /// The next one; nothing when the base is silent for two seconds.
  [[nodiscard]] std::optional<Position> next() const {
    char text[128] = "";
    if (::recv(socket_.get(), text, sizeof text - 1, 0) <= 0) return std::nullopt;
    Position position;
    const bool whole = std::sscanf(text, "pos %lf %lf", &position.x, &position.y) == 2;
    return whole ? std::optional(position) : std::nullopt;
  }
  /// The position once all that has come is read.
  [[nodiscard]] std::optional<Position> now() const {
    char text[128];
    while (::recv(socket_.get(), text, sizeof text, MSG_DONTWAIT) > 0) continue;
    return next();
  }

 private:
  FileDescriptor socket_;
};

class LauncherKilledTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> base() const {
    return {Stack::program("kobuki_simulator"),
            "--link",
            folder_.path("kobuki"),
            "--start",
            "0,0,0",
            "--position",
            folder_.path("position"),
            "--walls",
            Stack::share("config/maps/classroom.walls.yaml"),
            "--config",
            Stack::share("config/base.yaml")};
  }
  /// Whether it drives on for 0.3 m from now within a minute.
  [[nodiscard]] bool drives() const {
    const auto from = position_.now();
    const auto end = Clock::now() + seconds(60);
    while (from && Clock::now() < end) {
      const auto at = position_.next();
      if (at && between(*from, *at) > 0.3) return true;
    }
    return false;
  }

  const TemporaryFolder folder_;
  const PositionFeed position_{folder_.path("position")};
};

TEST_F(LauncherKilledTest, TheBaseComesToRestByItsOwnTimeout) {
  const OperatorProcess wheels(base(), folder_.path("base.log"));
  Stack stack({"mission.yaml", "--seed", "1", "--without", "uxv/base", "--without", "uxv/payload",
               "--without", "gcs/view", "--set",
               "kobuki_driver.device_port=" + folder_.path("kobuki")});
  ASSERT_TRUE(drives()) << stack.output();
  const pid_t driver = stack.pid("uxv/drive");
  const auto at_kill = position_.now();
  const auto killed = Clock::now();
  ::kill(stack.launcher(), SIGKILL);
  // The base's 0.5 s, braking, and a position each 0.1 s.
  constexpr auto limit = milliseconds(1200);
  std::optional<Position> rest;
  while (Clock::now() < killed + limit) rest = position_.next();
  ASSERT_TRUE(at_kill && rest) << "the base is not heard any more";
  EXPECT_LT(between(*at_kill, *rest), 0.5);
  for (int i = 0; i < 20; ++i) {
    const auto later = position_.next();
    ASSERT_TRUE(later);
    EXPECT_LT(between(*rest, *later), 0.005);
  }
  EXPECT_NE(driver, 0);
  EXPECT_NE(::kill(driver, 0), 0) << "the driver has outlived its launcher";
  std::printf("came to rest after %.2f m\n", between(*at_kill, *rest));
}

}  // namespace
}  // namespace tocsin
