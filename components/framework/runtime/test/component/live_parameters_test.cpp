// SPDX-License-Identifier: Apache-2.0
// How a component's class tells its parameters, and takes others while it runs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <functional>

#include "runtime/component_entry.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

class Lamp : public Component {
 public:
  struct Params {
    double low = 0.2;
    double high = 0.8;
    template <class Visitor>
    void visit(Visitor& v) {
      live(v)("low", low, {0, 1}, "[1] dim");
      live(v)("high", high, {0, 1}, "[1] bright");
    }
  };
  static void check(const Params& params) {
    if (params.low > params.high) throw ConfigError("low: is above high");
  }
  Lamp(Context& context, const Params& params) : Component(context), params_(params) {}
  void set_parameters(const Params& params) { params_ = params; }
  void tick(Time) override { seen.push_back(params_.low); }
  std::vector<double> seen;

 private:
  Params params_;
};

class Rock : public Component {
 public:
  struct Params {
    template <class Visitor>
    void visit(Visitor&) {}
  };
  Rock(Context& context, const Params&) : Component(context) {}
  void tick(Time) override {}
};

std::string error_of(const std::function<void()>& body) {
  try {
    body();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "";
}

class LiveParametersTest : public ::testing::Test {
 protected:
  SimBus bus_;
  Context context_{bus_, "lamp", Role::uxv};
  const ComponentEntry entry_ = make_component_entry<Lamp>();
};

TEST_F(LiveParametersTest, AreTakenBeforeTheNextTickWhichTheyAskFor) {
  Lamp sut(context_, {});
  bus_.add(sut);
  entry_.change(sut, YAML::Load("{low: 0.5}"), {});
  EXPECT_EQ(sut.seen, std::vector<double>{0.2});
  bus_.run_for(Duration::zero());
  EXPECT_EQ(sut.seen, (std::vector<double>{0.2, 0.5}));
}

TEST_F(LiveParametersTest, TheLastOfSeveralBetweenTwoTicksStands) {
  Lamp sut(context_, {});
  bus_.add(sut);
  entry_.change(sut, YAML::Load("{low: 0.5}"), {});
  entry_.change(sut, YAML::Load("{low: 0.6}"), {});
  bus_.run_for(Duration::zero());
  EXPECT_EQ(sut.seen, (std::vector<double>{0.2, 0.6}));
}

TEST_F(LiveParametersTest, ARuleAcrossThemHoldsAtTheStartAndWhileItRuns) {
  const YAML::Node wrong = YAML::Load("{low: 0.9}");
  EXPECT_THAT(error_of([&] { entry_.check("lamp", wrong, {}); }), HasSubstr("low: is above high"));
  EXPECT_THAT(error_of([&] { (void)entry_.create(context_, wrong, {}); }),
              HasSubstr("low: is above high"));
  Lamp sut(context_, {});
  bus_.add(sut);
  EXPECT_THAT(error_of([&] { entry_.change(sut, wrong, {}); }), HasSubstr("low: is above high"));
  bus_.run_for(seconds(1));
  EXPECT_EQ(sut.seen, std::vector<double>{0.2});
}

TEST_F(LiveParametersTest, OutsideOfTheirRangeAreRefused) {
  Lamp sut(context_, {});
  EXPECT_THAT(error_of([&] { entry_.change(sut, YAML::Load("{low: 2}"), {}); }),
              HasSubstr("lamp.low: 2 is outside [0, 1]"));
}

TEST_F(LiveParametersTest, FactsAreThoseOfTheGivenValues) {
  const auto facts = entry_.facts("lamp", YAML::Load("{high: 0.9}"), {});
  ASSERT_EQ(facts.size(), 2U);
  EXPECT_EQ(facts[0].value, ParameterValue(0.2));
  EXPECT_EQ(facts[1].value, ParameterValue(0.9));
  EXPECT_TRUE(facts[1].live);
}

TEST_F(LiveParametersTest, AComponentWithoutThemTakesNone) {
  const ComponentEntry entry = make_component_entry<Rock>();
  Rock sut(context_, {});
  EXPECT_THAT(error_of([&] { entry.change(sut, YAML::Node(), {}); }),
              HasSubstr("lamp: its parameters are fixed while it runs"));
  EXPECT_TRUE(entry.facts("lamp", YAML::Node(), {}).empty());
}

TEST_F(LiveParametersTest, WhatIsPostedIsDoneOnceInItsOrder) {
  Lamp sut(context_, {});
  bus_.add(sut);
  std::vector<int> done;
  sut.post([&] { done.push_back(1); });
  sut.post([&] { done.push_back(2); });
  EXPECT_TRUE(done.empty());
  bus_.run_for(seconds(1));
  EXPECT_EQ(done, (std::vector<int>{1, 2}));
  EXPECT_EQ(sut.seen.size(), 2U);
}

}  // namespace
}  // namespace tocsin
