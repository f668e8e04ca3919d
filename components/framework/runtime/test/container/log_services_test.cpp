// SPDX-License-Identifier: Apache-2.0
// What the nodes of a container log, as ROS 2 reads it and says how much it shall be.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "container/control_rig.hpp"
#include "container/logger_services.hpp"
#include "container/rosout.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Of the whole process, as a line that repeats within a second is not written.
int said = 0;

/// Says something in each tick, differently.
class Speaker : public Component {
 public:
  struct Params {
    template <class Visitor>
    void visit(Visitor&) {}
  };
  Speaker(Context& context, const Params&) : Component(context) {}
  void tick(Time) override {
    log().debug("detail {}", ++said);
    log().warn("warning {}", said);
    wake_at(bus().now() + seconds(1));
  }
};

const ComponentEntry& entry_of(const std::string&) {
  static const ComponentEntry entry = make_component_entry<Speaker>();
  return entry;
}

class LogServicesTest : public ControlRig {
 protected:
  LogServicesTest() : ControlRig(entry_of) {
    add("speaker", "speaker");
    add("speaker", "other");
    start();
    instances_.activate_all();
  }
  ~LogServicesTest() override {
    for (const char* node : {"", "speaker", "other"}) log_levels::set(node, LogLevel::unset);
  }
  rcl_interfaces::msg::SetLoggerLevelsResult set(const std::string& name, std::uint32_t level) {
    Asker<logger_service::SetLoggerLevels> sut(bus_, "speaker");
    rcl_interfaces::msg::LoggerLevel one;
    one.name(name);
    one.level(level);
    logger_service::SetLoggerLevels::Request request;
    request.levels({one});
    const auto response = sut.ask(request);
    EXPECT_TRUE(response && response->results().size() == 1);
    return response ? response->results()[0] : rcl_interfaces::msg::SetLoggerLevelsResult();
  }
  /// Texts of a node, of what has come since the last call.
  std::vector<std::string> told(const std::string& node) {
    std::vector<std::string> texts;
    for (const auto& one : rosout_.take()) {
      if (one.name() == node) texts.push_back(one.msg());
    }
    return texts;
  }

  SimReader<RosoutTopic> rosout_{bus_};
};

TEST_F(LogServicesTest, EachLineIsOnRosoutWithItsNodeAndLevel) {
  bus_.run_for(seconds(0.5));
  const auto lines = rosout_.take();
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0].name(), "speaker");
  EXPECT_EQ(lines[0].msg(), "warning " + std::to_string(said - 1));
  EXPECT_EQ(lines[0].level(), rcl_interfaces::msg::Log_Constants::WARN);
  EXPECT_GT(lines[0].stamp().sec(), 1'700'000'000);
  EXPECT_EQ(lines[1].name(), "other");
}

TEST_F(LogServicesTest, WhoComesLateHearsTheLastOfThem) {
  bus_.run_for(seconds(2.5));
  SimReader<RosoutTopic> late(bus_);
  EXPECT_EQ(late.take().size(), 6U);
}

TEST_F(LogServicesTest, ALevelIsSetAndReadByTheNameOfTheLogger) {
  EXPECT_TRUE(set("speaker", 10).successful());
  (void)rosout_.take();
  bus_.run_for(seconds(1));
  EXPECT_THAT(told("speaker"), ElementsAre(HasSubstr("detail"), HasSubstr("warning")));
  EXPECT_TRUE(set("speaker", 40).successful());
  (void)rosout_.take();
  bus_.run_for(seconds(2));
  EXPECT_THAT(told("speaker"), IsEmpty());
  Asker<logger_service::GetLoggerLevels> get(bus_, "other");
  logger_service::GetLoggerLevels::Request names;
  names.names({"speaker", "other"});
  const auto levels = get.ask(names)->levels();
  ASSERT_EQ(levels.size(), 2U);
  EXPECT_EQ(levels[0].level(), 40U);
  EXPECT_EQ(levels[1].level(), 0U);
}

TEST_F(LogServicesTest, WhatIsNoLoggerOrNoLevelIsRefusedWithAReason) {
  EXPECT_THAT(set("nobody", 10).reason(), HasSubstr("nobody: no logger of this process"));
  EXPECT_THAT(set("speaker", 11).reason(), HasSubstr("11 is no level"));
  EXPECT_EQ(log_levels::of("nobody"), LogLevel::unset);
  EXPECT_EQ(log_levels::of("speaker"), LogLevel::unset);
}

TEST_F(LogServicesTest, TheEmptyNameIsThatOfAllNodes) {
  Asker<logger_service::GetLoggerLevels> get(bus_, "speaker");
  logger_service::GetLoggerLevels::Request all;
  all.names({""});
  EXPECT_EQ(get.ask(all)->levels().at(0).level(), 20U);
  EXPECT_TRUE(set("", 40).successful());
  EXPECT_EQ(get.ask(all)->levels().at(0).level(), 40U);
  (void)rosout_.take();
  bus_.run_for(seconds(2));
  EXPECT_THAT(told("other"), IsEmpty());
}

TEST_F(LogServicesTest, TheControlItselfHasTheNodeOfItsContainer) {
  EXPECT_TRUE(set("drive_container", 30).successful());
  EXPECT_EQ(log_levels::of("drive_container"), LogLevel::warn);
  log_levels::set("drive_container", LogLevel::unset);
}

TEST(LoggerName, HasTheNamespaceInFrontWithADot) {
  EXPECT_EQ(logger_name("uxv", "navigator"), "uxv.navigator");
  EXPECT_EQ(logger_name("", "navigator"), "navigator");
  EXPECT_EQ(node_of_logger("uxv", "uxv.navigator"), "navigator");
  EXPECT_EQ(node_of_logger("uxv", "navigator"), "navigator");
  EXPECT_EQ(node_of_logger("uxv", "uxv"), "");
  EXPECT_EQ(node_of_logger("", "navigator"), "navigator");
}

}  // namespace
}  // namespace tocsin
