// SPDX-License-Identifier: Apache-2.0
#include "service_text.hpp"

#include <gtest/gtest.h>

#include "ros_idl/geometry_msgs.hpp"
#include "ros_idl/rcl_interfaces.hpp"
#include "ros_idl/std_srvs.hpp"

namespace tocsin::topic_tool {
namespace {

GraphEnd end(const std::string& topic, const std::string& type) {
  GraphEnd made;
  made.topic = topic;
  made.type = type;
  return made;
}

const std::vector<GraphEnd> ends{
    end("rq/lamp/setRequest", "std_srvs::srv::dds_::SetBool_Request_"),
    end("rr/lamp/setReply", "std_srvs::srv::dds_::SetBool_Response_"),
    end("rq/dock/_action/send_goalRequest", "a::action::dds_::Dock_SendGoal_Request_"),
    end("rt/odom", "nav_msgs::msg::dds_::Odometry_")};

TEST(ServiceList, ShowsBothTypesWhenTheEndsDisagree) {
  std::vector<GraphEnd> two = ends;
  two.push_back(end("rq/lamp/setRequest", "std_srvs::srv::dds_::Trigger_Request_"));
  ServiceListOptions options;
  options.types = true;
  EXPECT_EQ(service_list_text(two, options),
            "/lamp/set [std_srvs/srv/SetBool, std_srvs/srv/Trigger]\n");
  EXPECT_EQ(services_in(two).at("/lamp/set").size(), 2U);
}

TEST(PythonText, ShowsAMessageAsRos2ServiceCallDoes) {
  std_srvs::srv::SetBool_Request request;
  request.data(true);
  EXPECT_EQ(python_text(type_info<std_srvs::srv::SetBool_Request>(), &request),
            "std_srvs.srv.SetBool_Request(data=True)");
  EXPECT_EQ(python_text(type_info<std_srvs::srv::Trigger_Request>(),
                        std::make_shared<std_srvs::srv::Trigger_Request>().get()),
            "std_srvs.srv.Trigger_Request()");
  std_srvs::srv::SetBool_Response response;
  response.message("it's on");
  EXPECT_EQ(python_text(type_info<std_srvs::srv::SetBool_Response>(), &response),
            "std_srvs.srv.SetBool_Response(success=False, message='it's on')");
}

}  // namespace
}  // namespace tocsin::topic_tool
