// SPDX-License-Identifier: Apache-2.0
#include "pseudo_terminal.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <string>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"

namespace tocsin::kobuki {
namespace {

namespace fs = std::filesystem;

class PseudoTerminalTest : public ::testing::Test {
 protected:
  void SetUp() override {
    try {
      const PseudoTerminal possible(link_);
    } catch (const EnvironmentError& error) {
      GTEST_SKIP() << error.what();
    }
  }
  [[nodiscard]] FileDescriptor open_port() const {
    return FileDescriptor(::open(link_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  }
  static void send(PseudoTerminal& terminal, const std::string& text) {
    terminal.send({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  }
  static std::string received(PseudoTerminal& terminal) {
    pollfd waiting{terminal.descriptor(), POLLIN, 0};
    (void)::poll(&waiting, 1, 2000);
    std::array<std::uint8_t, 64> bytes{};
    return {reinterpret_cast<const char*>(bytes.data()),
            terminal.receive(bytes.data(), bytes.size())};
  }
  static std::string read(const FileDescriptor& port) {
    pollfd waiting{port.get(), POLLIN, 0};
    (void)::poll(&waiting, 1, 2000);
    std::array<char, 64> text{};
    const ssize_t size = ::read(port.get(), text.data(), text.size());
    return {text.data(), size > 0 ? static_cast<std::size_t>(size) : 0};
  }

  const TemporaryFolder folder_;
  const std::string link_ = folder_.path("kobuki");
};

TEST_F(PseudoTerminalTest, CarriesBytesBothWaysAsTheyAre) {
  PseudoTerminal sut(link_);
  const FileDescriptor port = open_port();
  ASSERT_TRUE(port);
  const std::string odd("\x00\x03\x04\r\n\xff", 6);  // what a terminal that is not raw would change
  send(sut, odd);
  EXPECT_EQ(read(port), odd);
  ASSERT_EQ(::write(port.get(), odd.data(), odd.size()), 6);
  EXPECT_EQ(received(sut), odd);
}

TEST_F(PseudoTerminalTest, IsInUseWhileAProgramHasItOpen) {
  const PseudoTerminal sut(link_);
  EXPECT_FALSE(sut.in_use());
  {
    const FileDescriptor port = open_port();
    EXPECT_TRUE(sut.in_use());
  }
  EXPECT_FALSE(sut.in_use());
}

TEST_F(PseudoTerminalTest, WhatIsSentWhileNobodyListensIsLost) {
  PseudoTerminal sut(link_);
  send(sut, "old");
  const FileDescriptor port = open_port();
  send(sut, "new");
  EXPECT_EQ(read(port), "new");
}

TEST_F(PseudoTerminalTest, NothingWaitingIsNothingReceived) {
  PseudoTerminal sut(link_);
  std::uint8_t byte = 7;
  EXPECT_EQ(sut.receive(&byte, 1), 0U);
  EXPECT_EQ(byte, 7);
}

TEST_F(PseudoTerminalTest, AFullPortLosesBytesAndDoesNotBlock) {
  PseudoTerminal sut(link_);
  const FileDescriptor port = open_port();
  for (int i = 0; i < 10'000; ++i) send(sut, "0123456789");
  EXPECT_EQ(read(port).substr(0, 10), "0123456789");
}

TEST_F(PseudoTerminalTest, AFreshOneIsUnderTheSameLinkAndKnowsNoExclusiveUser) {
  PseudoTerminal sut(link_);
  {
    const FileDescriptor port = open_port();
    ASSERT_EQ(::ioctl(port.get(), TIOCEXCL), 0);
  }
  const fs::path before = fs::read_symlink(link_);
  sut.renew();
  EXPECT_TRUE(fs::is_symlink(link_));
  const FileDescriptor port = open_port();
  ASSERT_TRUE(port) << "not even locked for others, from " << before;
  send(sut, "x");
  EXPECT_EQ(read(port), "x");
}

TEST_F(PseudoTerminalTest, WhenTheCableIsPulledTerminalAndLinkDisappear) {
  PseudoTerminal sut(link_);
  const FileDescriptor port = open_port();
  sut.remove();
  EXPECT_FALSE(sut.is_open());
  EXPECT_FALSE(sut.in_use());
  EXPECT_FALSE(fs::is_symlink(link_));
  EXPECT_EQ(read(port), "") << "the end";
  send(sut, "into nothing");
  sut.renew();
  EXPECT_TRUE(sut.is_open());
  EXPECT_TRUE(open_port());
}

TEST_F(PseudoTerminalTest, ReplacesAStaleLinkAndTakesItsOwnAway) {
  fs::create_symlink("/nowhere/at/all", link_);
  {
    const PseudoTerminal sut(link_);
    EXPECT_TRUE(open_port());
  }
  EXPECT_FALSE(fs::is_symlink(link_));
}

TEST_F(PseudoTerminalTest, RefusesToReplaceAFileOrAFolder) {
  folder_.write("kobuki", "precious");
  EXPECT_THROW(PseudoTerminal{link_}, ConfigError);
  EXPECT_EQ(folder_.read("kobuki"), "precious");
  EXPECT_THROW(PseudoTerminal{folder_.path()}, ConfigError);
}

TEST_F(PseudoTerminalTest, SaysWhereItCannotMakeItsLink) {
  try {
    const PseudoTerminal sut(folder_.path("no/such/folder/kobuki"));
    FAIL() << "made";
  } catch (const EnvironmentError& error) {
    EXPECT_NE(std::string(error.what()).find("no/such/folder/kobuki"), std::string::npos);
  }
}

}  // namespace
}  // namespace tocsin::kobuki
