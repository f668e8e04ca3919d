// SPDX-License-Identifier: Apache-2.0
// Parameters of the components of a container, as ROS 2 asks for them.
#include "container/parameter_services.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "container/control_rig.hpp"

namespace tocsin {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
namespace type = rcl_interfaces::msg::ParameterType_Constants;

/// What the component under test has seen.
std::vector<double> speeds;

class Driver : public Component {
 public:
  struct Params {
    double speed_mps = 0.3;
    double limit_mps = 1;
    bool lit = true;
    template <class Visitor>
    void visit(Visitor& v) {
      live(v)("speed_mps", speed_mps, {0, 2}, "[m/s] of the mission");
      live(v)("limit_mps", limit_mps, {0, 2}, "[m/s] never above");
      v("lit", lit, "lamp");
    }
  };
  static void check(const Params& params) {
    if (params.speed_mps > params.limit_mps) {
      throw ConfigError("speed_mps: is above limit_mps");
    }
  }
  Driver(Context& context, const Params& params) : Component(context), params_(params) {}
  void set_parameters(const Params& params) { params_ = params; }
  void tick(Time) override { speeds.push_back(params_.speed_mps); }

 private:
  Params params_;
};

/// Its parameters are fixed.
class Plain : public Component {
 public:
  struct Params {
    int number = 3;
    template <class Visitor>
    void visit(Visitor& v) {
      v("number", number, {0, 9}, "of it");
    }
  };
  Plain(Context& context, const Params&) : Component(context) {}
  void tick(Time) override {}
};

const ComponentEntry& entry_of(const std::string& library) {
  static const ComponentEntry driver = make_component_entry<Driver>();
  static const ComponentEntry plain = make_component_entry<Plain>();
  return library == "driver" ? driver : plain;
}

struct Unheard : ClientReceiver {
  void receive(ServiceReply&&) override {}
  void wake() override {}
};

rcl_interfaces::msg::Parameter given(const std::string& name, const ParameterValue& value) {
  rcl_interfaces::msg::Parameter parameter;
  parameter.name(name);
  parameter.value(ros_value(value));
  return parameter;
}

class ParameterServicesTest : public ControlRig {
 protected:
  ParameterServicesTest() : ControlRig(entry_of, "") {
    speeds.clear();
    add("driver", "driver", "{speed_mps: 0.4}");
    add("plain", "plain");
    instances_.activate_all();
  }
  rcl_interfaces::msg::SetParametersResult set_one(const std::string& name,
                                                   const ParameterValue& value) {
    Asker<parameter_service::SetParameters> sut(bus_, "driver");
    parameter_service::SetParameters::Request request;
    request.parameters({given(name, value)});
    const auto response = sut.ask(request);
    EXPECT_TRUE(response && response->results().size() == 1);
    return response ? response->results().at(0) : rcl_interfaces::msg::SetParametersResult();
  }
  double speed() {
    Asker<parameter_service::GetParameters> sut(bus_, "driver");
    parameter_service::GetParameters::Request request;
    request.names({"speed_mps"});
    const auto response = sut.ask(request);
    return response ? response->values().at(0).double_value() : -1;
  }
};

TEST_F(ParameterServicesTest, AreListedReadAndDescribedAsTheyAre) {
  start();
  Asker<parameter_service::ListParameters> list(bus_, "driver");
  EXPECT_THAT(list.ask({})->result().names(), ElementsAre("speed_mps", "limit_mps", "lit"));
  Asker<parameter_service::GetParameters> get(bus_, "driver");
  parameter_service::GetParameters::Request names;
  names.names({"speed_mps", "lit", "none"});
  const auto values = get.ask(names)->values();
  ASSERT_EQ(values.size(), 3U);
  EXPECT_EQ(values[0].double_value(), 0.4);
  EXPECT_TRUE(values[1].bool_value());
  EXPECT_EQ(values[2].type(), type::PARAMETER_NOT_SET);
  Asker<parameter_service::GetParameterTypes> types(bus_, "driver");
  parameter_service::GetParameterTypes::Request of;
  of.names({"lit", "speed_mps"});
  EXPECT_THAT(types.ask(of)->types(), ElementsAre(type::PARAMETER_BOOL, type::PARAMETER_DOUBLE));
  Asker<parameter_service::DescribeParameters> describe(bus_, "driver");
  parameter_service::DescribeParameters::Request which;
  which.names({"lit", "none"});
  const auto descriptors = describe.ask(which)->descriptors();
  ASSERT_EQ(descriptors.size(), 2U);
  EXPECT_TRUE(descriptors[0].read_only());
  EXPECT_EQ(descriptors[1].name(), "none");
  EXPECT_EQ(descriptors[1].type(), type::PARAMETER_NOT_SET);
}

TEST_F(ParameterServicesTest, ALiveOneIsSetFromTheNextTickOnAndTold) {
  start();
  SimReader<ParameterEvents> events(bus_);
  EXPECT_TRUE(set_one("speed_mps", 0.7).successful());
  EXPECT_EQ(speeds.back(), 0.7);
  EXPECT_EQ(speed(), 0.7);
  const auto told = events.take();
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].node(), "/driver");
  ASSERT_EQ(told[0].changed_parameters().size(), 1U);
  EXPECT_EQ(told[0].changed_parameters()[0].value().double_value(), 0.7);
}

TEST_F(ParameterServicesTest, WhatCannotBeIsRefusedWithOneReasonAndChangesNothing) {
  start();
  for (const auto& [name, value, reason] :
       std::vector<std::tuple<const char*, ParameterValue, const char*>>{
           {"lit", false, "driver.lit: is fixed while the component runs"},
           {"speed_mps", 3.0, "driver.speed_mps: 3 is outside [0, 2]"},
           {"speed_mps", std::string("fast"), "driver.speed_mps: is of type double, not string"},
           {"speed_mps", 1.5, "speed_mps: is above limit_mps"},
           {"speed", 1.0, "driver.speed: there is no such parameter"}}) {
    const auto result = set_one(name, value);
    EXPECT_FALSE(result.successful()) << name;
    EXPECT_THAT(result.reason(), HasSubstr(reason));
  }
  EXPECT_EQ(speed(), 0.4);
  EXPECT_EQ(speeds.back(), 0.4);
}

TEST_F(ParameterServicesTest, SetAtomicallyAreAllOrNone) {
  start();
  Asker<parameter_service::SetParametersAtomically> sut(bus_, "driver");
  parameter_service::SetParametersAtomically::Request both;
  both.parameters({given("speed_mps", 1.5), given("limit_mps", 2.0)});
  EXPECT_TRUE(sut.ask(both)->result().successful());
  EXPECT_EQ(speed(), 1.5);
  both.parameters({given("speed_mps", 0.1), given("lit", false)});
  EXPECT_FALSE(sut.ask(both)->result().successful());
  EXPECT_EQ(speed(), 1.5);
}

TEST_F(ParameterServicesTest, AFixedOneTakesTheValueThatItHasSoThatADumpCanBeLoaded) {
  start();
  SimReader<ParameterEvents> events(bus_);
  EXPECT_TRUE(set_one("lit", true).successful());
  EXPECT_TRUE(events.take().empty()) << "nothing has changed";
  EXPECT_FALSE(set_one("lit", false).successful());
  EXPECT_FALSE(set_one("lit", std::string("true")).successful());
  Asker<parameter_service::SetParametersAtomically> sut(bus_, "driver");
  parameter_service::SetParametersAtomically::Request dump;
  dump.parameters({given("speed_mps", 0.4), given("limit_mps", 1.0), given("lit", true)});
  EXPECT_TRUE(sut.ask(dump)->result().successful());
  ASSERT_EQ(events.take().size(), 1U);
  EXPECT_EQ(speed(), 0.4);
}

TEST_F(ParameterServicesTest, OneByOneAreSetAsFarAsTheyCanBe) {
  start();
  Asker<parameter_service::SetParameters> sut(bus_, "driver");
  parameter_service::SetParameters::Request request;
  request.parameters({given("speed_mps", 0.1), given("lit", false)});
  const auto results = sut.ask(request)->results();
  ASSERT_EQ(results.size(), 2U);
  EXPECT_TRUE(results[0].successful());
  EXPECT_FALSE(results[1].successful());
  EXPECT_EQ(speed(), 0.1);
}

TEST_F(ParameterServicesTest, OfAComponentWithoutLiveOnesCanBeReadOnly) {
  start();
  Asker<parameter_service::SetParameters> sut(bus_, "plain");
  parameter_service::SetParameters::Request request;
  request.parameters({given("number", std::int64_t{4})});
  EXPECT_THAT(sut.ask(request)->results().at(0).reason(), HasSubstr("plain.number: is fixed"));
}

TEST_F(ParameterServicesTest, AreThereOnlyForTheNodeThatIsAskedAndForAWhile) {
  start();
  {
    const Asker<parameter_service::ListParameters> sut(bus_, "driver");
    EXPECT_TRUE(sut.available());
  }
  // Looks without calling: an end that is made and gone within one instant.
  const auto served = [&](const std::string& node) {
    Unheard unheard;
    return bus_
        .call({node + "/list_parameters", &type_info<parameter_service::ListParameters::Request>(),
               &type_info<parameter_service::ListParameters::Response>()},
              unheard)
        ->available();
  };
  EXPECT_TRUE(served("driver"));
  EXPECT_FALSE(served("plain"));
  bus_.run_for(seconds(12));
  EXPECT_FALSE(served("driver"));
}

// `ros2 param list` waits 5 s for each node that has none of these services.
TEST_F(ParameterServicesTest, OfTheContainerItselfAreThereAndEmpty) {
  start();
  Asker<parameter_service::ListParameters> list(bus_, "control");
  const auto names = list.ask({});
  ASSERT_NE(names, nullptr);
  EXPECT_TRUE(names->result().names().empty());
  Asker<parameter_service::SetParameters> set(bus_, "control");
  parameter_service::SetParameters::Request request;
  request.parameters({given("x", ParameterValue(1.0))});
  const auto results = set.ask(request)->results();
  ASSERT_EQ(results.size(), 1U);
  EXPECT_EQ(results[0].reason(), "a container has no parameters");
}

TEST_F(ParameterServicesTest, AreNeverThereWhenTheBringupFileSaysSo) {
  start(Mode::never);
  EXPECT_FALSE((Asker<parameter_service::ListParameters>(bus_, "driver").available()));
}

TEST_F(ParameterServicesTest, AreThereFromTheStartWhenTheyShallAlwaysBe) {
  start(Mode::always);
  Unheard unheard;
  const auto end =
      bus_.call({"plain/set_parameters", &type_info<parameter_service::SetParameters::Request>(),
                 &type_info<parameter_service::SetParameters::Response>()},
                unheard);
  EXPECT_TRUE(end->available());
}

TEST_F(ParameterServicesTest, AreKnownByTheirNames) {
  EXPECT_TRUE(calls_services_of("driver", {"x", "driver/get_parameter_types"}));
  EXPECT_FALSE(calls_services_of("driver", {"driver/reset", "other/get_parameters"}));
  EXPECT_FALSE(calls_services_of("driver", {}));
}

}  // namespace
}  // namespace tocsin
