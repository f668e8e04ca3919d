// SPDX-License-Identifier: Apache-2.0
#include "graph/node_of_service.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

TEST(NodeOfService, IsWhatStandsBeforeAServiceThatEveryNodeHas) {
  EXPECT_EQ(node_of_service("navigator/get_parameters"), "navigator");
  EXPECT_EQ(node_of_service("navigator/set_parameters_atomically"), "navigator");
  EXPECT_EQ(node_of_service("navigator/get_logger_levels"), "navigator");
  EXPECT_EQ(node_of_service("navigator/get_state"), "navigator");
  EXPECT_EQ(node_of_service("arm/left/list_parameters"), "arm/left");
}

TEST(NodeOfService, OfAnotherServiceThereIsNone) {
  EXPECT_EQ(node_of_service("dock"), "");
  EXPECT_EQ(node_of_service("navigator/dock"), "");
  EXPECT_EQ(node_of_service("/get_parameters"), "");
  EXPECT_EQ(node_of_service("get_parameters"), "");
  EXPECT_EQ(node_of_service("navigator/forget_parameters"), "");
}

}  // namespace
}  // namespace tocsin
