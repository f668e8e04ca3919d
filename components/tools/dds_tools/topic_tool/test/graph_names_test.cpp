// SPDX-License-Identifier: Apache-2.0
// What the pages on topics, services and nodes have in common.
#include "graph_names.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "python_float.hpp"

namespace tocsin::topic_tool {
namespace {

Gid gid(std::uint8_t last) {
  Gid made{};
  made.back() = last;
  return made;
}

GraphEnd end(std::uint8_t its_gid, bool writer) {
  GraphEnd made;
  made.gid = gid(its_gid);
  made.writer = writer;
  return made;
}

TEST(IsHidden, IsAPartThatBeginsWithAnUnderscore) {
  EXPECT_TRUE(is_hidden("/_discovery"));
  EXPECT_TRUE(is_hidden("/uxv/dock/_action/feedback"));
  EXPECT_FALSE(is_hidden("/cmd_vel"));
  EXPECT_FALSE(is_hidden("/a_/b_c"));
  EXPECT_FALSE(is_hidden(""));
}

TEST(TypesText, DoesNotGiveATerminalTheBytesOfOthers) {
  const std::string shown = types_text({"a/msg/\x1b[2J"});
  EXPECT_EQ(shown.find('\x1b'), std::string::npos) << shown;
}

TEST(HasEnd, TellsReadersAndWritersApart) {
  const GraphNode node{"/uxv", "lamp", {gid(2)}, {gid(1)}};
  EXPECT_TRUE(has_end(node, end(1, true)) != has_end(node, end(1, false)));
  EXPECT_TRUE(has_end(node, end(2, false)) != has_end(node, end(2, true)));
  EXPECT_FALSE(has_end(node, end(3, true)));
  EXPECT_FALSE(has_end(node, end(3, false)));
}

}  // namespace
}  // namespace tocsin::topic_tool
