// SPDX-License-Identifier: Apache-2.0
// A running container and its nodes, asked as rmw_fastrtps and rmw_cyclonedds ask: raw participants
// of both makers call services that are made only when somebody calls them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "cyclone_service.hpp"
#include "fast_dds_service.hpp"
#include "foundation/temporary_folder.hpp"
#include "headed_nodes.h"
#include "idl_support/decode.hpp"
#include "idl_support/encode.hpp"
#include "operator_process.hpp"
#include "ros_idl/composition_interfaces.hpp"
#include "ros_idl/lifecycle_msgs.hpp"
#include "ros_idl/rcl_interfaces.hpp"
#include "stack.hpp"
#include "within.hpp"

namespace tocsin::interop {
namespace {

using ::testing::ElementsAre;
namespace composition = composition_interfaces::srv;
namespace lifecycle = lifecycle_msgs::srv;
namespace rcl = rcl_interfaces::srv;

/// `tocsin run talker`: the container `talker_container` with the node `talker`.
class Talker {
 public:
  explicit Talker(int domain)
      : process_({"/bin/bash", "-c",
                  "source " + Stack::setup() + " && exec tocsin run talker --host uxv --domain " +
                      std::to_string(domain) + " --run-dir " + folder_.path()},
                 folder_.path("output")) {}

 private:
  const TemporaryFolder folder_;
  const OperatorProcess process_;
};

/// Names on the wire of a service of a node.
struct ServiceNames {
  ServiceNames(const std::string& node, const std::string& name, const std::string& type)
      : request{"rq/" + node + "/" + name + "Request", type + "_Request_"},
        reply{"rr/" + node + "/" + name + "Reply", type + "_Response_"} {}
  FastDdsService::Half request;
  FastDdsService::Half reply;
};
const ServiceNames list_nodes("talker_container", "_container/list_nodes",
                              "composition_interfaces::srv::dds_::ListNodes");
const ServiceNames load_node("talker_container", "_container/load_node",
                             "composition_interfaces::srv::dds_::LoadNode");
const ServiceNames set_parameters("second", "set_parameters",
                                  "rcl_interfaces::srv::dds_::SetParameters");
const ServiceNames change_state("second", "change_state", "lifecycle_msgs::srv::dds_::ChangeState");

/// The answer to one request of rmw_fastrtps; null when there is none.
template <class Response, class Request>
std::shared_ptr<const Response> ask_fast(int domain, const ServiceNames& names,
                                         const Request& request) {
  FastDdsService client(domain, names.request, names.reply);
  EXPECT_TRUE(eventually([&] { return client.is_connected(); })) << names.request.topic;
  FastDdsService::Identity asked;
  asked.writer_guid(client.reader_guid());
  const std::int64_t number = client.write(encode(type_info<Request>(), &request), asked);
  std::optional<FastDdsService::Taken> reply;
  EXPECT_TRUE(eventually([&] { return (reply = client.take()).has_value(); }));
  if (!reply) return nullptr;
  EXPECT_EQ(reply->related.sequence_number().to64long(), number);
  return std::static_pointer_cast<const Response>(decode(type_info<Response>(), reply->bytes));
}

struct CycloneTypes {
  const dds_topic_descriptor_t& request;
  const dds_topic_descriptor_t& response;
};

/// Calls `use` with the answer to one request of rmw_cyclonedds.
template <class Response, class Request, class Use>
void ask_cyclone(int domain, const ServiceNames& names, const CycloneTypes& types, Request request,
                 const Use& use) {
  CycloneService<Response, Request> client(domain, types.request, names.request, types.response,
                                           names.reply);
  ASSERT_TRUE(eventually([&] { return client.is_connected(); })) << names.request.topic;
  request.client = 0x1122334455667788;
  request.number = 42;
  client.write(request);
  bool came = false;
  EXPECT_TRUE(eventually([&] {
    client.take([&](const Response& response) {
      EXPECT_EQ(response.client, request.client);
      EXPECT_EQ(response.number, request.number);
      use(response.body);
      came = true;
    });
    return came;
  }));
}

rcl_interfaces::msg::Parameter text(const std::string& value) {
  rcl_interfaces::msg::Parameter made;
  made.name("text");
  made.value().type(rcl_interfaces::msg::ParameterType_Constants::PARAMETER_STRING);
  made.value().string_value(value);
  return made;
}

TEST(ContainerServices, AreAnsweredAsRmwFastrtpsAsks) {
  constexpr int domain = 75;
  const Talker sut(domain);
  const auto listed = ask_fast<composition::ListNodes_Response>(domain, list_nodes,
                                                                composition::ListNodes_Request());
  ASSERT_TRUE(listed);
  EXPECT_THAT(listed->full_node_names(), ElementsAre("/talker"));

  composition::LoadNode_Request load;
  load.plugin_name("talker");
  load.node_name("second");
  load.parameters({text("from Fast DDS")});
  const auto loaded = ask_fast<composition::LoadNode_Response>(domain, load_node, load);
  ASSERT_TRUE(loaded);
  EXPECT_TRUE(loaded->success()) << loaded->error_message();
  EXPECT_EQ(loaded->full_node_name(), "/second");

  rcl::SetParameters_Request set;
  set.parameters({text("set by Fast DDS")});
  const auto changed = ask_fast<rcl::SetParameters_Response>(domain, set_parameters, set);
  ASSERT_TRUE(changed);
  ASSERT_EQ(changed->results().size(), 1U);
  EXPECT_TRUE(changed->results()[0].successful()) << changed->results()[0].reason();

  lifecycle::ChangeState_Request stop;
  stop.transition().label("deactivate");
  const auto stopped = ask_fast<lifecycle::ChangeState_Response>(domain, change_state, stop);
  ASSERT_TRUE(stopped);
  EXPECT_TRUE(stopped->success());
}

void cyclone_lists_nodes(int domain) {
  ask_cyclone<headed_ListNodesResponse>(
      domain, list_nodes, {headed_ListNodesRequest_desc, headed_ListNodesResponse_desc},
      headed_ListNodesRequest{}, [](const auto& response) {
        ASSERT_EQ(response.full_node_names._length, 1U);
        EXPECT_STREQ(response.full_node_names._buffer[0], "/talker");
        EXPECT_EQ(response.unique_ids._buffer[0], 1U);
      });
}

void cyclone_loads_a_node(int domain, rcl_interfaces_msg_Parameter& parameter) {
  std::string nothing;
  std::string plugin = "talker";
  std::string node = "second";
  headed_LoadNodeRequest load{};
  load.body.package_name = load.body.node_namespace = nothing.data();
  load.body.plugin_name = plugin.data();
  load.body.node_name = node.data();
  load.body.parameters._length = 1;
  load.body.parameters._buffer = &parameter;
  ask_cyclone<headed_LoadNodeResponse>(domain, load_node,
                                       {headed_LoadNodeRequest_desc, headed_LoadNodeResponse_desc},
                                       load, [](const auto& response) {
                                         EXPECT_TRUE(response.success) << response.error_message;
                                         EXPECT_STREQ(response.full_node_name, "/second");
                                         EXPECT_EQ(response.unique_id, 2U);
                                       });
}

void cyclone_sets_a_parameter(int domain, rcl_interfaces_msg_Parameter& parameter) {
  headed_SetParametersRequest set{};
  set.body.parameters._length = 1;
  set.body.parameters._buffer = &parameter;
  ask_cyclone<headed_SetParametersResponse>(
      domain, set_parameters, {headed_SetParametersRequest_desc, headed_SetParametersResponse_desc},
      set, [](const auto& response) {
        ASSERT_EQ(response.results._length, 1U);
        EXPECT_TRUE(response.results._buffer[0].successful) << response.results._buffer[0].reason;
      });
}

TEST(ContainerServices, AreAnsweredAsRmwCycloneddsAsks) {
  constexpr int domain = 76;
  const Talker sut(domain);
  cyclone_lists_nodes(domain);
  std::string name = "text";
  std::string value = "from Cyclone DDS";
  rcl_interfaces_msg_Parameter parameter{};
  parameter.name = name.data();
  parameter.value.type = rcl_interfaces::msg::ParameterType_Constants::PARAMETER_STRING;
  parameter.value.string_value = value.data();
  cyclone_loads_a_node(domain, parameter);
  cyclone_sets_a_parameter(domain, parameter);
  std::string deactivate = "deactivate";
  headed_ChangeStateRequest stop{};
  stop.body.transition.label = deactivate.data();
  ask_cyclone<headed_ChangeStateResponse>(
      domain, change_state, {headed_ChangeStateRequest_desc, headed_ChangeStateResponse_desc}, stop,
      [](const auto& response) { EXPECT_TRUE(response.success); });
}

}  // namespace
}  // namespace tocsin::interop
