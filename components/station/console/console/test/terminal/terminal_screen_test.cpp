// SPDX-License-Identifier: Apache-2.0
#include "terminal/screen.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace tocsin::terminal {
namespace {

using ::testing::ElementsAre;

/// A terminal without a window.
class PseudoTerminal {
 public:
  PseudoTerminal() : master_(::posix_openpt(O_RDWR | O_NOCTTY)) {}
  ~PseudoTerminal() { ::close(master_); }
  [[nodiscard]] int descriptor() const { return master_; }
  void resize(unsigned short columns, unsigned short rows) const {
    winsize size{};
    size.ws_col = columns;
    size.ws_row = rows;
    ASSERT_EQ(::ioctl(master_, TIOCSWINSZ, &size), 0);
  }

 private:
  int master_;
};

std::pair<std::size_t, std::size_t> size(const PseudoTerminal& terminal) {
  const Size told = size_of(terminal.descriptor());
  return {told.columns, told.rows};
}

TEST(SizeOf, FollowsTheTerminal) {
  const PseudoTerminal terminal;
  ASSERT_GE(terminal.descriptor(), 0);
  terminal.resize(40, 10);
  EXPECT_EQ(size(terminal), std::make_pair(std::size_t{40}, std::size_t{10}));
  terminal.resize(200, 60);
  EXPECT_EQ(size(terminal), std::make_pair(std::size_t{200}, std::size_t{60}));
}

TEST(SizeOf, IsTheUsualOneWhereTheTerminalDoesNotKnow) {
  const PseudoTerminal terminal;
  terminal.resize(0, 0);
  EXPECT_EQ(size(terminal), std::make_pair(std::size_t{80}, std::size_t{24}));
}

TEST(Shortened, TellsHowManyAreMissing) {
  const std::vector<Line> lines{{{"head"}}, {{"a"}}, {{"b"}}, {{"c"}}};
  EXPECT_THAT(to_texts(shortened(lines, 4, "rows"), {80, 24}, false),
              ElementsAre("head", "a", "b", "c"));
  EXPECT_THAT(to_texts(shortened(lines, 3, "rows"), {80, 24}, false),
              ElementsAre("head", "a", "and 2 rows more"));
  EXPECT_TRUE(shortened(lines, 2, "rows").empty());
}

TEST(Frame, WritesOverEveryRowAndClearsBelow) {
  EXPECT_EQ(frame({{{"one"}}, {{"two"}}}, {80, 24}), "\x1b[H\x1b[2Kone\r\n\x1b[2Ktwo\r\n\x1b[J");
  EXPECT_EQ(frame({}, {80, 24}), "\x1b[H\x1b[J");
}

TEST(Frame, AFullScreenDoesNotScroll) {
  EXPECT_EQ(frame({{{"one"}}, {{"two"}}}, {80, 2}), "\x1b[H\x1b[2Kone\r\n\x1b[2Ktwo");
}

}  // namespace
}  // namespace tocsin::terminal
