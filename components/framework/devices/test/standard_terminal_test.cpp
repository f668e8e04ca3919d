// SPDX-License-Identifier: Apache-2.0
// The terminal of this process, in a pseudo-terminal or a pipe in place of standard input.
#include "standard_terminal.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <string>
#include <utility>

namespace tocsin {
namespace {

using ::testing::internal::CaptureStdout;
using ::testing::internal::GetCapturedStdout;

/// Standard input is `descriptor` as long as this lives.
class StandardInput {
 public:
  explicit StandardInput(int descriptor) : before_(::dup(STDIN_FILENO)) {
    ::dup2(descriptor, STDIN_FILENO);
    ::close(descriptor);
  }
  ~StandardInput() {
    ::dup2(before_, STDIN_FILENO);
    ::close(before_);
  }
  StandardInput(const StandardInput&) = delete;
  StandardInput& operator=(const StandardInput&) = delete;

 private:
  int before_;
};

class TerminalTest : public ::testing::Test {
 protected:
  TerminalTest() : keyboard_(::posix_openpt(O_RDWR | O_NOCTTY)) {
    ::grantpt(keyboard_);
    ::unlockpt(keyboard_);
  }
  ~TerminalTest() override {
    if (keyboard_ >= 0) ::close(keyboard_);
  }
  /// The end that the program has; -1 where pseudo-terminals are those of another instance.
  [[nodiscard]] int screen() const {
    const char* const name = ::ptsname(keyboard_);
    return name == nullptr ? -1 : ::open(name, O_RDWR | O_NOCTTY);
  }
  void type(const std::string& keys) const {
    ASSERT_EQ(::write(keyboard_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
  }
  static tcflag_t local_modes() {
    termios now{};
    EXPECT_EQ(::tcgetattr(STDIN_FILENO, &now), 0);
    return now.c_lflag;
  }
  int keyboard_;
};

TEST_F(TerminalTest, GivesEachKeyAtOnceWithoutEnterAndLeavesTheModesAsTheyWere) {
  const int end = screen();
  if (end < 0) GTEST_SKIP() << "pseudo-terminals of another instance";
  const StandardInput input(end);
  const tcflag_t before = local_modes();
  CaptureStdout();
  {
    const auto sut = open_standard_terminal();
    EXPECT_EQ(local_modes() & static_cast<tcflag_t>(ICANON | ECHO), 0U);
    EXPECT_NE(local_modes() & static_cast<tcflag_t>(ISIG), 0U) << "Ctrl-C ends";
    EXPECT_EQ(sut->read(), "") << "nothing typed, and it does not wait";
    type("w\x1b[A");
    pollfd waiting{*sut->descriptor(), POLLIN, 0};
    ASSERT_EQ(::poll(&waiting, 1, 5000), 1);
    EXPECT_EQ(sut->read(), "w\x1b[A");
  }
  EXPECT_EQ(local_modes(), before);
  EXPECT_EQ(GetCapturedStdout(), "\n") << "the prompt comes below";
}

TEST_F(TerminalTest, ALineReplacesTheOneBefore) {
  const int end = screen();
  if (end < 0) GTEST_SKIP() << "pseudo-terminals of another instance";
  const StandardInput input(end);
  CaptureStdout();
  const auto sut = open_standard_terminal();
  sut->print("help\n");
  sut->show("0.3 m/s");
  EXPECT_EQ(GetCapturedStdout(), "help\n\r\x1b[K0.3 m/s");
}

TEST_F(TerminalTest, AClosedTerminalHasNoMoreKeys) {
  const int end = screen();
  if (end < 0) GTEST_SKIP() << "pseudo-terminals of another instance";
  const StandardInput input(end);
  const auto sut = open_standard_terminal();
  ::close(std::exchange(keyboard_, -1));
  EXPECT_EQ(sut->read(), std::nullopt);
}

TEST(TerminalOfAPipe, IsReadAsItIsAndShowsNoLineThatWouldBeReplaced) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  const StandardInput input(ends[0]);
  CaptureStdout();
  const auto sut = open_standard_terminal();
  sut->show("0.3 m/s");
  ASSERT_EQ(::write(ends[1], "wa", 2), 2);
  EXPECT_EQ(sut->read(), "wa");
  ::close(ends[1]);
  EXPECT_EQ(sut->read(), std::nullopt);
  EXPECT_EQ(GetCapturedStdout(), "");
}

}  // namespace
}  // namespace tocsin
