// SPDX-License-Identifier: Apache-2.0
// Names of what ROS 2 asks every node.
#include "container/node_services.hpp"

#include <gtest/gtest.h>

namespace tocsin {
namespace {

TEST(NodeServiceNames, EachOfThemCountsAsACallOfItsNode) {
  for (const char* name :
       {"describe_parameters", "get_parameters", "get_parameter_types", "list_parameters",
        "set_parameters", "set_parameters_atomically", "get_logger_levels", "set_logger_levels",
        "change_state", "get_state", "get_available_states", "get_available_transitions",
        "get_transition_graph", "get_type_description"}) {
    EXPECT_TRUE(calls_services_of("arm", {std::string("arm/") + name})) << name;
    EXPECT_FALSE(calls_services_of("arm", {std::string("leg/") + name})) << name;
  }
  EXPECT_FALSE(calls_services_of("arm", {"arm/reset", "arm/_container/list_nodes"}));
}

TEST(NodeServiceNames, ThoseOfAContainerAreItsOwn) {
  for (const char* name : {"load_node", "unload_node", "list_nodes"}) {
    EXPECT_TRUE(calls_composition_of("drive_container",
                                     {std::string("drive_container/_container/") + name}));
    EXPECT_FALSE(calls_composition_of("drive_container", {std::string("drive_container/") + name}));
  }
}

}  // namespace
}  // namespace tocsin
