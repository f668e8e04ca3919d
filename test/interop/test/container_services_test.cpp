// SPDX-License-Identifier: Apache-2.0
// A running container, asked for its nodes as rmw_fastrtps and rmw_cyclonedds ask: its services are
// made only when a participant of either vendor calls them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "cyclone_service.hpp"
#include "fast_dds_service.hpp"
#include "foundation/temporary_folder.hpp"
#include "headed_services.h"
#include "idl_support/decode.hpp"
#include "idl_support/encode.hpp"
#include "operator_process.hpp"
#include "ros_idl/composition_interfaces.hpp"
#include "stack.hpp"
#include "within.hpp"

namespace tocsin::interop {
namespace {

using ::testing::ElementsAre;
using Request = composition_interfaces::srv::ListNodes_Request;
using Response = composition_interfaces::srv::ListNodes_Response;

const FastDdsService::Half request_half{"rq/talker_container/_container/list_nodesRequest",
                                        "composition_interfaces::srv::dds_::ListNodes_Request_"};
const FastDdsService::Half reply_half{"rr/talker_container/_container/list_nodesReply",
                                      "composition_interfaces::srv::dds_::ListNodes_Response_"};

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

TEST(ContainerServices, AreAnsweredAsRmwFastrtpsAsks) {
  constexpr int domain = 75;
  const Talker sut(domain);
  FastDdsService client(domain, request_half, reply_half);
  ASSERT_TRUE(eventually([&] { return client.is_connected(); }));
  const Request request;
  FastDdsService::Identity asked;
  asked.writer_guid(client.reader_guid());
  const std::int64_t number = client.write(encode(type_info<Request>(), &request), asked);
  std::optional<FastDdsService::Taken> reply;
  ASSERT_TRUE(eventually([&] { return (reply = client.take()).has_value(); }));
  EXPECT_EQ(reply->related.sequence_number().to64long(), number);
  const auto nodes =
      std::static_pointer_cast<const Response>(decode(type_info<Response>(), reply->bytes));
  ASSERT_TRUE(nodes);
  EXPECT_THAT(nodes->full_node_names(), ElementsAre("/talker"));
}

TEST(ContainerServices, AreAnsweredAsRmwCycloneddsAsks) {
  constexpr int domain = 76;
  const Talker sut(domain);
  CycloneService<headed_ListNodesResponse, headed_ListNodesRequest> client(
      domain, headed_ListNodesRequest_desc, request_half, headed_ListNodesResponse_desc,
      reply_half);
  ASSERT_TRUE(eventually([&] { return client.is_connected(); }));
  headed_ListNodesRequest request{};
  request.client = 0x1122334455667788;
  request.number = 42;
  client.write(request);
  bool came = false;
  EXPECT_TRUE(eventually([&] {
    client.take([&](const headed_ListNodesResponse& response) {
      came = true;
      EXPECT_EQ(response.client, request.client);
      EXPECT_EQ(response.number, request.number);
      ASSERT_EQ(response.body.full_node_names._length, 1U);
      EXPECT_STREQ(response.body.full_node_names._buffer[0], "/talker");
    });
    return came;
  }));
}

}  // namespace
}  // namespace tocsin::interop
