// SPDX-License-Identifier: Apache-2.0
#include "operator_server/topic_ports.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/sim_bus.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::foxglove {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class Owner final : public Component {
 public:
  using Component::Component;
  void tick(Time /*now*/) override {}
};

ClientChannel channel(const std::string& topic, const std::string& type) {
  return {1, topic, "json", type};
}

class TopicPortsTest : public ::testing::Test {
 protected:
  TopicPortsTest() { sut_.set_topics(stated_picture("").topics); }
  [[nodiscard]] std::vector<std::string> read(const std::set<std::string>& topics) {
    std::vector<std::string> faults;
    sut_.read(topics, faults);
    return faults;
  }
  [[nodiscard]] std::size_t readings() const { return owner_.port_health().size(); }
  [[nodiscard]] std::string write(const std::string& topic, const std::string& payload) {
    return sut_.write({1, topic, "json", payload}).fault;
  }
  SimBus bus_;
  Context context_{bus_, "owner", Role::gcs};
  Owner owner_{context_};
  TopicPorts sut_{owner_};
};

TEST_F(TopicPortsTest, ReadsWhatIsWantedAndNothingElse) {
  EXPECT_THAT(read({"/goal", "/location"}), IsEmpty());
  EXPECT_EQ(readings(), 2U);
  EXPECT_THAT(read({"/goal"}), IsEmpty());
  EXPECT_EQ(readings(), 1U);
  EXPECT_THAT(read({"/no_such_topic"}), IsEmpty());
  EXPECT_EQ(readings(), 0U);
}

TEST_F(TopicPortsTest, EndsTheReadingOfATopicThatIsGoneOrOfAnotherTypeNow) {
  EXPECT_THAT(read({"/goal", "/location"}), IsEmpty());
  auto topics = stated_picture("").topics;
  for (SeenTopic& one : topics) {
    if (one.name == "/goal") one.type = &type_info<std_msgs::msg::Bool>();
    if (one.name == "/location") one.name = "/elsewhere";
  }
  sut_.set_topics(topics);
  EXPECT_EQ(readings(), 0U);
}

TEST_F(TopicPortsTest, ATopicThatTheBusRefusesIsNamedOnce) {
  const SeenTopic clashing{"/clashing", topic::Goal::info, &type_info<std_msgs::msg::Bool>()};
  sut_.set_topics({clashing});
  bus_.publish<topic::Goal>({});
  const auto faults = read({"/clashing"});
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_THAT(faults[0], HasSubstr("clashes with tocsin_msgs::msg::dds_::Goal_"));
  EXPECT_THAT(read({"/clashing"}), IsEmpty());
}

TEST_F(TopicPortsTest, WritesATopicThatALibraryStatesByItsType) {
  SimReader<topic::Goal> goals(bus_);
  EXPECT_EQ(sut_.open(channel("/goal", "tocsin_msgs/msg/Goal")), "");
  EXPECT_EQ(sut_.open(channel("/goal", "tocsin_msgs/msg/Goal")), "") << "by a second client";
  EXPECT_EQ(write("/goal", R"({"id": 3})"), "");
  const auto came = goals.take();
  ASSERT_EQ(came.size(), 1U);
  EXPECT_EQ(came[0].id(), 3U);
}

TEST_F(TopicPortsTest, SaysUnderWhoseNameAPersonDrivesOrAsksTo) {
  EXPECT_EQ(sut_.open(channel("/teleop/cmd_vel", "geometry_msgs/msg/TwistStamped")), "");
  EXPECT_EQ(sut_.open(channel("/teleop/request", "tocsin_msgs/msg/DriverRequest")), "");
  EXPECT_EQ(sut_.open(channel("/goal", "tocsin_msgs/msg/Goal")), "");
  EXPECT_EQ(
      sut_.write({1, "/teleop/cmd_vel", "json", R"({"header": {"frame_id": "anna"}})"}).by_operator,
      "anna");
  EXPECT_EQ(sut_.write({1, "/teleop/request", "json", R"({"name": "ben"})"}).by_operator, "ben");
  EXPECT_FALSE(sut_.write({1, "/goal", "json", "{}"}).by_operator);
}

TEST_F(TopicPortsTest, AnObserverReleasesNoStopAndOnlyASupervisorTakesControl) {
  const auto write_as = [this](UserRole role, const std::string& topic, const std::string& text) {
    return sut_.write({1, topic, "json", text, role}).fault;
  };
  const std::string stop = "/emergency_stop/request";
  EXPECT_EQ(sut_.open(channel(stop, "std_msgs/msg/Bool")), "");
  EXPECT_EQ(write_as(UserRole::observer, stop, R"({"data": true})"), "");
  EXPECT_EQ(write_as(UserRole::observer, stop, R"({"data": false})"),
            stop + ": an observer may press the emergency stop, and not release it");
  EXPECT_EQ(write_as(UserRole::driver, stop, R"({"data": false})"), "");

  const std::string request = "/teleop/request";
  EXPECT_EQ(sut_.open(channel(request, "tocsin_msgs/msg/DriverRequest")), "");
  EXPECT_EQ(write_as(UserRole::driver, request, R"({"name": "ben", "verb": "ask"})"), "");
  EXPECT_EQ(write_as(UserRole::driver, request, R"({"name": "ben", "verb": "take"})"),
            request + ": only a supervisor takes control; ask for it");
  EXPECT_EQ(write_as(UserRole::supervisor, request, R"({"name": "ben", "verb": "take"})"), "");
}

TEST_F(TopicPortsTest, WritesATopicThatNobodyStates) {
  EXPECT_EQ(sut_.open(channel("/crew/remark", "std_msgs/msg/String")), "");
  EXPECT_EQ(write("/crew/remark", R"({"data": "fog"})"), "");
  EXPECT_THAT(sut_.open(channel("/crew/remark", "std_msgs/msg/Bool")),
              HasSubstr("/crew/remark: has the type std_msgs/msg/String, not std_msgs/msg/Bool"));
}

TEST_F(TopicPortsTest, EachChannelThatCannotBeIsNamed) {
  const std::pair<ClientChannel, const char*> cases[] = {
      {channel("goal", "tocsin_msgs/msg/Goal"), "goal: is not a name of a topic"},
      {channel("/", "tocsin_msgs/msg/Goal"), "/: is not a name of a topic"},
      {channel("/a//b", "tocsin_msgs/msg/Goal"), "is not a name of a topic"},
      {channel("/a b", "tocsin_msgs/msg/Goal"), "is not a name of a topic"},
      {channel("/a\n", "tocsin_msgs/msg/Goal"), "/a\\n: is not a name of a topic"},
      {channel("/goal", "tocsin_msgs/msg/Gaol"), "has the type 'tocsin_msgs/msg/Gaol'"},
      {channel("/goal", ""), "has the type ''"},
      {channel("/goal", "std_msgs/msg/Bool"), "has the type tocsin_msgs/msg/Goal, not"},
  };
  for (const auto& [wish, fault] : cases) EXPECT_THAT(sut_.open(wish), HasSubstr(fault));
}

TEST_F(TopicPortsTest, WhatIsNotOpenAnyMoreIsNotWritten) {
  EXPECT_THAT(write("/goal", "{}"), HasSubstr("/goal: is not open"));
  EXPECT_EQ(sut_.open(channel("/goal", "tocsin_msgs/msg/Goal")), "");
  sut_.keep({"/goal"});
  EXPECT_EQ(write("/goal", "{}"), "");
  sut_.keep({});
  EXPECT_THAT(write("/goal", "{}"), HasSubstr("/goal: is not open"));
}

TEST_F(TopicPortsTest, ABadMessageIsNotWritten) {
  SimReader<topic::Goal> goals(bus_);
  EXPECT_EQ(sut_.open(channel("/goal", "tocsin_msgs/msg/Goal")), "");
  EXPECT_THAT(write("/goal", R"({"id": -1})"), HasSubstr("/goal: id: must be a whole number"));
  EXPECT_THAT(sut_.write({1, "/goal", "cdr", "abc"}).fault, HasSubstr("3 bytes are not the CDR"));
  EXPECT_THAT(goals.take(), IsEmpty());
}

}  // namespace
}  // namespace tocsin::foxglove
