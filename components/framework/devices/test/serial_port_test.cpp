// SPDX-License-Identifier: Apache-2.0
#include "serial_port.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <vector>

namespace tocsin {
namespace {

/// A terminal whose other end is the test.
struct Terminal {
  Terminal() : master(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK)) {
    ::grantpt(master);
    ::unlockpt(master);
    path = ::ptsname(master);
  }
  ~Terminal() { hang_up(); }
  void hang_up() {
    if (master >= 0) ::close(master);
    master = -1;
  }
  int master;
  std::string path;
};

/// A process that keeps the port open until it is destroyed.
struct Holder {
  explicit Holder(const std::string& path) {
    int ready[2];
    EXPECT_EQ(::pipe(ready), 0);
    pid = ::fork();
    if (pid == 0) {
      const auto opened = open_serial_port(path);
      const char result = opened.device ? 'y' : 'n';
      if (::write(ready[1], &result, 1) == 1) ::pause();
      ::_exit(0);
    }
    char result = 0;
    EXPECT_EQ(::read(ready[0], &result, 1), 1);
    EXPECT_EQ(result, 'y');
    ::close(ready[0]);
    ::close(ready[1]);
  }
  ~Holder() {
    ::kill(pid, SIGKILL);
    ::waitpid(pid, nullptr, 0);
  }
  pid_t pid = -1;
};

TEST(SerialPort, CarriesRawBytesBothWays) {
  Terminal terminal;
  auto sut = open_serial_port(terminal.path);
  ASSERT_EQ(sut.result, OpenedSerial::Result::open) << sut.reason;
  const std::uint8_t sent[]{0x0D, 0x0A, 0x03,
                            0x00, 0x11, 0xFF};  // a cooked line would change these
  ASSERT_EQ(::write(terminal.master, sent, sizeof sent), 6);
  std::uint8_t got[16] = {};
  EXPECT_EQ(sut.device->read(got, sizeof got), 6U);
  EXPECT_TRUE(std::equal(std::begin(sent), std::end(sent), got));
  EXPECT_TRUE(sut.device->write(sent, sizeof sent));
  EXPECT_EQ(::read(terminal.master, got, sizeof got), 6);
  EXPECT_EQ(got[1], 0x0A);
}

TEST(SerialPort, ReadsNothingWithoutBlocking) {
  Terminal terminal;
  auto sut = open_serial_port(terminal.path);
  std::uint8_t byte = 0;
  EXPECT_EQ(sut.device->read(&byte, 1), 0U);
}

TEST(SerialPort, TellsThatItWasLost) {
  Terminal terminal;
  auto sut = open_serial_port(terminal.path);
  terminal.hang_up();
  std::uint8_t byte = 0;
  EXPECT_FALSE(sut.device->read(&byte, 1));
  EXPECT_FALSE(sut.device->write(&byte, 1));
}

TEST(SerialPort, DropsWhatDoesNotFitWithoutBlocking) {
  Terminal terminal;
  auto sut = open_serial_port(terminal.path);
  const std::vector<std::uint8_t> much(1000, 7);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(sut.device->write(much.data(), much.size()));
}

TEST(SerialPort, IsAbsentWhenThereIsNone) {
  const auto sut = open_serial_port("/nonexistent/port");
  EXPECT_EQ(sut.result, OpenedSerial::Result::absent);
  EXPECT_NE(sut.reason.find("/nonexistent/port: No such file"), std::string::npos);
}

TEST(SerialPort, IsAbsentWhenItIsNoTerminal) {
  EXPECT_EQ(open_serial_port("/dev/null").result, OpenedSerial::Result::absent);
}

TEST(SerialPort, IsBusyAndNamesTheHolder) {
  Terminal terminal;
  const Holder holder(terminal.path);
  const auto sut = open_serial_port(terminal.path);
  EXPECT_EQ(sut.result, OpenedSerial::Result::busy);
  EXPECT_TRUE(sut.held);
  EXPECT_NE(sut.reason.find("(pid " + std::to_string(holder.pid) + ")"), std::string::npos)
      << sut.reason;
  EXPECT_EQ(sut.reason.rfind(terminal.path + " is in use by serial_port_tes", 0), 0U) << sut.reason;
}

TEST(SerialPort, RespectsTheLockOfTheReferenceDriver) {
  Terminal terminal;
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t pid = ::fork();
  if (pid == 0) {
    const int fd = ::open(terminal.path.c_str(), O_RDWR | O_NOCTTY);
    struct flock whole {};
    whole.l_type = F_WRLCK;
    const char result = ::fcntl(fd, F_SETLK, &whole) == 0 ? 'y' : 'n';
    if (::write(ready[1], &result, 1) == 1) ::pause();
    ::_exit(0);
  }
  char result = 0;
  ASSERT_EQ(::read(ready[0], &result, 1), 1);
  EXPECT_EQ(open_serial_port(terminal.path).result, OpenedSerial::Result::busy);
  ::kill(pid, SIGKILL);
  ::waitpid(pid, nullptr, 0);
}

TEST(SerialPort, IsFreeAgainAfterItsHolderWasKilled) {
  Terminal terminal;
  { const Holder holder(terminal.path); }
  const auto sut = open_serial_port(terminal.path);
  // Without privileges a pseudo-terminal stays exclusive; no living process holds it, though.
  EXPECT_TRUE(sut.result == OpenedSerial::Result::open || !sut.held);
}

}  // namespace
}  // namespace tocsin
