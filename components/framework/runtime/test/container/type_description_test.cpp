// SPDX-License-Identifier: Apache-2.0
// What ROS 2 asks a node about its types.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "container/control_rig.hpp"
#include "container/type_description_service.hpp"
#include "ros_idl/geometry_msgs.hpp"
#include "ros_idl/std_srvs.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

GetTypeDescription::Request request_of(const char* hash, bool sources = true) {
  GetTypeDescription::Request request;
  request.type_hash(hash);
  request.include_type_sources(sources);
  return request;
}

template <class Message>
GetTypeDescription::Response describe(bool sources = true) {
  return describe_type(request_of(type_info<Message>().ros_hash, sources));
}

std::vector<std::string> parts_of(const GetTypeDescription::Response& response) {
  std::vector<std::string> names;
  for (const auto& one : response.type_description().referenced_type_descriptions()) {
    names.push_back(one.type_name());
  }
  return names;
}

TEST(TypeDescription, HasTheFieldsOfATypeAndOfItsParts) {
  const auto response = describe<geometry_msgs::msg::PoseWithCovariance>();
  ASSERT_TRUE(response.successful()) << response.failure_reason();
  const auto& own = response.type_description().type_description();
  EXPECT_EQ(own.type_name(), "geometry_msgs/msg/PoseWithCovariance");
  ASSERT_EQ(own.fields().size(), 2U);
  EXPECT_EQ(own.fields()[0].name(), "pose");
  EXPECT_EQ(own.fields()[0].type().type_id(), 1);
  EXPECT_EQ(own.fields()[0].type().nested_type_name(), "geometry_msgs/msg/Pose");
  EXPECT_EQ(own.fields()[1].type().type_id(), 11 + 48);  // an array of float64
  EXPECT_EQ(own.fields()[1].type().capacity(), 36U);
  EXPECT_THAT(parts_of(response), ElementsAre("geometry_msgs/msg/Point", "geometry_msgs/msg/Pose",
                                              "geometry_msgs/msg/Quaternion"));
}

TEST(TypeDescription, HasTheTextOfAMessageWhereItIsAskedFor) {
  const auto sources = describe<geometry_msgs::msg::Twist>().type_sources();
  ASSERT_EQ(sources.size(), 2U);
  EXPECT_EQ(sources[0].encoding(), "msg");
  EXPECT_THAT(sources[1].raw_file_contents(), HasSubstr("float64 x\n"));
  EXPECT_THAT(describe<geometry_msgs::msg::Twist>(false).type_sources(), IsEmpty());
}

TEST(TypeDescription, APartOfAServiceIsImplicit) {
  const auto response = describe<std_srvs::srv::Trigger_Response>();
  ASSERT_EQ(response.type_sources().size(), 1U);
  EXPECT_EQ(response.type_sources()[0].encoding(), "implicit");
  EXPECT_EQ(response.type_sources()[0].raw_file_contents(), "");
}

TEST(TypeDescription, OfWhatIsNoHashOrNoTypeThereIsAReasonAndNoDescription) {
  const std::string some = type_info<geometry_msgs::msg::Twist>().ros_hash;
  const std::string other = some.substr(0, some.size() - 1) + (some.back() == '0' ? "1" : "0");
  EXPECT_THAT(describe_type(request_of(other.c_str())).failure_reason(),
              HasSubstr("no type of this node has the hash " + other));
  for (const std::string& wrong :
       {std::string(), some.substr(1), some + "0", "RIHS02_" + some.substr(7),
        some.substr(0, some.size() - 1) + "g"}) {
    const auto response = describe_type(request_of(wrong.c_str()));
    EXPECT_FALSE(response.successful());
    EXPECT_THAT(response.failure_reason(), HasSubstr("is no type hash"));
  }
}

class Idle : public Component {
 public:
  struct Params {
    template <class Visitor>
    void visit(Visitor&) {}
  };
  Idle(Context& context, const Params&) : Component(context) {}
  void tick(Time) override {}
};

const ComponentEntry& idle(const std::string&) {
  static const ComponentEntry entry = make_component_entry<Idle>();
  return entry;
}

class ToldTypes : public ControlRig {
 protected:
  ToldTypes() : ControlRig(idle) {}
};

TEST_F(ToldTypes, AreToldByEachNodeToWhoAsks) {
  add("idle", "arm");
  start();
  for (const char* const node : {"arm", "drive_container"}) {
    Asker<GetTypeDescription> sut(bus_, node);
    const auto response = sut.ask(request_of(type_info<geometry_msgs::msg::Twist>().ros_hash));
    ASSERT_NE(response, nullptr) << node;
    EXPECT_TRUE(response->successful());
  }
  EXPECT_FALSE(Asker<GetTypeDescription>(bus_, "leg").available());
}

}  // namespace
}  // namespace tocsin
