// SPDX-License-Identifier: Apache-2.0
// The component on a real terminal, whose size changes.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <regex>

#include "live_view/live_view_component.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

/// A pseudo-terminal in place of standard output as long as it lives.
class TerminalAsOutput {
 public:
  TerminalAsOutput() : master_(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK)) {
    if (::grantpt(master_) != 0 || ::unlockpt(master_) != 0) return;
    const int slave = ::open(::ptsname(master_), O_RDWR | O_NOCTTY);
    std::fflush(stdout);
    before_ = ::dup(STDOUT_FILENO);
    ::dup2(slave, STDOUT_FILENO);
    ::close(slave);
  }
  ~TerminalAsOutput() {
    std::fflush(stdout);
    ::dup2(before_, STDOUT_FILENO);
    ::close(before_);
    ::close(master_);
  }
  void resize(terminal::Size wanted) const {
    winsize size{};
    size.ws_col = static_cast<unsigned short>(wanted.columns);
    size.ws_row = static_cast<unsigned short>(wanted.rows);
    ::ioctl(master_, TIOCSWINSZ, &size);
  }
  /// The rows of the last page that was drawn since the last call, without colours.
  [[nodiscard]] std::vector<std::string> page() const {
    std::string text;
    std::array<char, 4096> buffer{};
    for (ssize_t n = 0; (n = ::read(master_, buffer.data(), buffer.size())) > 0;) {
      text.append(buffer.data(), static_cast<std::size_t>(n));
    }
    text.erase(0, text.rfind("\x1b[H"));
    text = std::regex_replace(text, std::regex("\x1b\\[[0-9;]*[A-Za-z]|\r"), "");
    std::vector<std::string> rows(1);
    for (const char c : text) {
      if (c == '\n') {
        rows.emplace_back();
      } else {
        rows.back() += c;
      }
    }
    return rows;
  }

 private:
  int master_;
  int before_ = -1;
};

std::size_t widest(const std::vector<std::string>& rows) {
  std::size_t width = 0;
  for (const std::string& row : rows) width = std::max(width, terminal::width_of(row));
  return width;
}

tocsin_msgs::msg::TrafficReport report_of_many_topics() {
  tocsin_msgs::msg::TrafficReport report;
  report.role("uxv");
  report.topics().resize(30);
  for (std::size_t i = 0; i < report.topics().size(); ++i) {
    report.topics()[i].topic("a_topic_with_a_rather_long_name_" + std::to_string(i));
  }
  return report;
}

using Page = std::vector<std::string>;

/// The pages that it draws on one terminal that has these sizes one after the other.
std::vector<Page> pages_at(const std::vector<terminal::Size>& sizes) {
  const TerminalAsOutput output;
  SimBus bus;
  Context context{bus, "live_view", Role::gcs};
  LiveViewComponent sut(context, {});
  bus.add(sut);
  bus.publish<topic::TrafficReport>(report_of_many_topics());
  std::vector<Page> pages;
  for (const terminal::Size size : sizes) {
    output.resize(size);
    bus.run_for(seconds(1));
    pages.push_back(output.page());
  }
  return pages;
}

TEST(LiveViewOnATerminal, FitsItAndFollowsAResize) {
  const auto pages = pages_at({{80, 24}, {40, 10}, {120, 60}});
  EXPECT_EQ(pages[0].size(), 24U);
  EXPECT_LE(widest(pages[0]), 80U);
  EXPECT_THAT(pages[0][0], ::testing::HasSubstr("Mission"));
  EXPECT_EQ(pages[1].size(), 10U);
  EXPECT_LE(widest(pages[1]), 40U);
  EXPECT_THAT(pages[1][0], ::testing::HasSubstr("Mission"));
  EXPECT_GT(pages[2].size(), 37U);
  EXPECT_EQ(pages[2][0], "Tocsin");
}

}  // namespace
}  // namespace tocsin
