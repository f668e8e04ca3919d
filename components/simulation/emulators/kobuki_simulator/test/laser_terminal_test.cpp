// SPDX-License-Identifier: Apache-2.0
#include "laser_terminal.hpp"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <unistd.h>

#include "foundation/error.hpp"
#include "foundation/file_descriptor.hpp"
#include "foundation/temporary_folder.hpp"
#include "laser_model/room.hpp"
#include "rplidar_protocol/decoder.hpp"

namespace tocsin::kobuki {
namespace {

class LaserTerminalTest : public ::testing::Test {
 protected:
  LaserTerminal::Params params(const std::string& profile = "rplidar_a1") {
    return {folder_.path("laser"), profile, {}};
  }
  /// What comes within a simulated second after a scan was asked for.
  std::size_t readings_of(int port) {
    const auto ask = rplidar::request(rplidar::Command::scan);
    EXPECT_EQ(::write(port, ask.data(), ask.size()), static_cast<ssize_t>(ask.size()));
    rplidar::Decoder decoder;
    for (int i = 0; i < 100; ++i, now_ += std::chrono::milliseconds(10)) {
      (void)sut_.step(base_, now_);
      std::uint8_t bytes[512];
      const auto count = ::read(port, bytes, sizeof bytes);
      if (count <= 0) continue;
      decoder.feed({bytes, static_cast<std::size_t>(count)}, [](const rplidar::Answer&) {});
    }
    return decoder.counts().readings;
  }
  [[nodiscard]] FileDescriptor open() {
    return FileDescriptor(::open(params().link.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK));
  }

  TemporaryFolder folder_;
  Time now_ = Time() + std::chrono::hours(1);
  laser::Room room_{{{2, -1, 2, 1, 6.9}}, {}, {}};
  BaseModel base_{{}, room_.touched(), {}, 1, now_};
  LaserTerminal sut_{params(), room_.seen(), 1, now_};
};

TEST_F(LaserTerminalTest, MeasuresBehindATerminalOfItsOwn) {
  now_ += std::chrono::seconds(2);
  const FileDescriptor port = open();
  ASSERT_TRUE(port);
  EXPECT_NEAR(static_cast<double>(readings_of(port.get())), 2000, 100);
}

TEST_F(LaserTerminalTest, GivesAFreshTerminalAfterItsUserHasLeft) {
  now_ += std::chrono::seconds(2);
  {
    const FileDescriptor first = open();
    (void)readings_of(first.get());
  }
  EXPECT_TRUE(sut_.step(base_, now_));
  const FileDescriptor second = open();
  ASSERT_TRUE(second);
  EXPECT_GT(readings_of(second.get()), 1000U);
}

TEST_F(LaserTerminalTest, ItsCableIsPulledAndPutBack) {
  EXPECT_EQ(sut_.obey("unplug", now_), "ok");
  EXPECT_EQ(sut_.obey("unplug", now_), "ok") << "again";
  EXPECT_FALSE(open());
  EXPECT_EQ(sut_.next_event(), never);
  EXPECT_EQ(sut_.obey("plug", now_), "ok");
  EXPECT_TRUE(sut_.step(base_, now_));
  EXPECT_TRUE(open());
}

TEST_F(LaserTerminalTest, RefusesWhatItCannotDo) {
  EXPECT_EQ(sut_.obey("jump", now_),
            "error: laser unplug|plug|stall|free|cover|uncover|stick|loosen");
  EXPECT_THROW(LaserTerminal(params("sonar"), room_.seen(), 1, now_), ConfigError);
}

}  // namespace
}  // namespace tocsin::kobuki
