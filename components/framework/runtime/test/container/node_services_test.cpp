// SPDX-License-Identifier: Apache-2.0
// Names and bytes of what ROS 2 asks every node, written down by hand from its interface files.
#include "container/node_services.hpp"

#include <gtest/gtest.h>

#include "idl_support/encode.hpp"
#include "runtime/middleware/ros_services.hpp"

namespace tocsin {
namespace {

using Bytes = std::vector<std::uint8_t>;

template <class Message>
Bytes bytes_of(const Message& message) {
  return encode(type_info<Message>(), &message);
}

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

TEST(LifecycleBytes, ATransitionIsItsNumberAndItsLabel) {
  lifecycle_service::ChangeState::Request request;
  request.transition().id(4);
  EXPECT_EQ(bytes_of(request), (Bytes{0, 1, 0, 0, 4, 0, 0, 0, 1, 0, 0, 0, 0}));
  request.transition().label("up");
  EXPECT_EQ(bytes_of(request), (Bytes{0, 1, 0, 0, 4, 0, 0, 0, 3, 0, 0, 0, 'u', 'p', 0}));
  lifecycle_service::ChangeState::Response response;
  response.success(true);
  EXPECT_EQ(bytes_of(response), (Bytes{0, 1, 0, 0, 1}));
}

TEST(LifecycleBytes, AnEmptyRequestIsOneByteAndAStateItsNumberAndLabel) {
  EXPECT_EQ(bytes_of(lifecycle_service::GetState::Request()), (Bytes{0, 1, 0, 0, 0}));
  lifecycle_service::GetState::Response response;
  response.current_state(ros_state(LifecycleState::active));
  EXPECT_EQ(bytes_of(response),
            (Bytes{0, 1, 0, 0, 3, 0, 0, 0, 7, 0, 0, 0, 'a', 'c', 't', 'i', 'v', 'e', 0}));
}

/// The value of half() where it begins 2 bytes behind a multiple of 8.
const Bytes half_of_double{3, 0, 0, 0,    0,    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
                           0, 0, 0, 0xe0, 0x3f, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
                           0, 0, 0, 0,    0,    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};

rcl_interfaces::msg::Parameter half() {
  rcl_interfaces::msg::Parameter parameter;
  parameter.name("a");
  parameter.value().type(3);
  parameter.value().double_value(0.5);
  return parameter;
}

TEST(ParameterBytes, AreAskedForByNameAndListedByPrefixAndDepth) {
  parameter_service::GetParameters::Request get;
  get.names({"a"});
  EXPECT_EQ(bytes_of(get), (Bytes{0, 1, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 'a', 0}));
  parameter_service::ListParameters::Request list;
  EXPECT_EQ(bytes_of(list), (Bytes{0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(ParameterBytes, OneIsSetByItsNameAndAValueOfAllTypes) {
  parameter_service::SetParameters::Request set;
  set.parameters({half()});
  Bytes expected{0, 1, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 'a', 0};
  expected.insert(expected.end(), half_of_double.begin(), half_of_double.end());
  EXPECT_EQ(bytes_of(set), expected);
  parameter_service::SetParameters::Response response;
  response.results().resize(1);
  response.results()[0].successful(true);
  EXPECT_EQ(bytes_of(response), (Bytes{0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0}));
}

TEST(CompositionBytes, ANodeIsLoadedByItsPluginWithItsParameters) {
  composition_service::LoadNode::Request request;
  request.package_name("pack");
  request.plugin_name("q");
  request.node_name("n");
  request.parameters({half()});
  Bytes expected{0, 1, 0,   0, 5, 0, 0, 0, 'p', 'a', 'c', 'k', 0, 0, 0, 0, 2,   0,
                 0, 0, 'q', 0, 0, 0, 2, 0, 0,   0,   'n', 0,   0, 0, 1, 0, 0,   0,
                 0, 0, 0,   0, 0, 0, 0, 0, 1,   0,   0,   0,   2, 0, 0, 0, 'a', 0};
  expected.insert(expected.end(), half_of_double.begin(), half_of_double.end());
  expected.insert(expected.end(), {0, 0, 0, 0});  // extra_arguments
  EXPECT_EQ(bytes_of(request), expected);
}

TEST(CompositionBytes, ANodeIsUnloadedByANumberOfEightBytes) {
  composition_service::UnloadNode::Request request;
  request.unique_id(0x0102030405060708);
  EXPECT_EQ(bytes_of(request), (Bytes{0, 1, 0, 0, 8, 7, 6, 5, 4, 3, 2, 1}));
  composition_service::UnloadNode::Response response;
  response.error_message("no");
  EXPECT_EQ(bytes_of(response), (Bytes{0, 1, 0, 0, 0, 0, 0, 0, 3, 0, 0, 0, 'n', 'o', 0}));
}

TEST(CompositionBytes, ListsOfNodesAreTwoSequences) {
  composition_service::ListNodes::Response response;
  EXPECT_EQ(bytes_of(response), (Bytes{0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
  response.full_node_names({"/a"});
  response.unique_ids({9});
  EXPECT_EQ(bytes_of(response), (Bytes{0, 1, 0, 0, 1, 0, 0, 0, 3, 0, 0, 0, '/', 'a',
                                       0, 0, 1, 0, 0, 0, 9, 0, 0, 0, 0, 0, 0,   0}));
}

TEST(LoggerBytes, ALevelIsItsNameAndFourBytes) {
  logger_service::SetLoggerLevels::Request request;
  request.levels().resize(1);
  request.levels()[0].name("a");
  request.levels()[0].level(10);
  EXPECT_EQ(bytes_of(request),
            (Bytes{0, 1, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 'a', 0, 0, 0, 10, 0, 0, 0}));
}

}  // namespace
}  // namespace tocsin
