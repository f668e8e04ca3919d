// SPDX-License-Identifier: Apache-2.0
#include "container/instances.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <map>
#include <set>
#include <stdexcept>

#include "foundation/error.hpp"
#include "runtime/port.hpp"
#include "runtime/sim_bus.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;

/// Throws where its parameters say.
class Fragile : public Component {
 public:
  struct Params {
    bool at_start = false;
    bool in_tick = false;
    template <class Visitor>
    void visit(Visitor& v) {
      v("at_start", at_start, "throws from the constructor");
      v("in_tick", in_tick, "throws from each tick");
    }
  };
  Fragile(Context& context, const Params& params) : Component(context), params_(params) {
    if (params.at_start) throw std::runtime_error("no device");
  }
  void tick(Time) override {
    if (params_.in_tick) throw std::runtime_error("broken");
    ++ticks;
    while (input_.take()) ++taken;
  }
  int ticks = 0;
  int taken = 0;

 private:
  Input<topic::Goal> input_{*this};
  Params params_;
};

const ComponentEntry& entry_of(const std::string& library) {
  static const ComponentEntry entry = make_component_entry<Fragile>();
  if (library != "fragile") throw ConfigError("component '" + library + "': no library");
  return entry;
}

/// Ticks all that were added when asked to.
class HandTicker : public Ticker {
 public:
  void add(Component& component, TickAccount& account) override { all_[&component] = &account; }
  bool remove(Component& component) override {
    if (stuck) return false;
    all_.erase(&component);
    return true;
  }
  void tick_all() {
    for (const auto& [component, account] : all_) {
      try {
        component->tick({});
      } catch (const std::exception& error) {
        account->fail(error.what());
      }
    }
  }
  [[nodiscard]] std::size_t size() const { return all_.size(); }
  bool stuck = false;

 private:
  std::map<Component*, TickAccount*> all_;
};

class InstancesTest : public ::testing::Test {
 protected:
  [[nodiscard]] LifecycleState state(const std::string& name) const {
    for (const Instance& one : sut_.all()) {
      if (one.name == name) return one.state;
    }
    throw std::runtime_error("no " + name);
  }
  [[nodiscard]] const Fragile& component(const std::string& name) const {
    for (const Instance& one : sut_.all()) {
      if (one.name == name) return dynamic_cast<const Fragile&>(*one.component);
    }
    throw std::runtime_error("no " + name);
  }
  SimBus bus_;
  HandTicker ticker_;
  Instances sut_{Context{bus_, "", Role::uxv}, ticker_, entry_of};
};

TEST_F(InstancesTest, LoadsAnActiveComponent) {
  const Outcome outcome = sut_.load("fragile", "a", "");
  EXPECT_TRUE(outcome.done) << outcome.text;
  EXPECT_EQ(outcome.text, "Loaded component 1 as 'a'");
  EXPECT_EQ(state("a"), LifecycleState::active);
  EXPECT_EQ(ticker_.size(), 1U);
}

TEST_F(InstancesTest, AComponentIsANodeOfItsOwnNameAndNotItsContainers) {
  Instances sut(Context(bus_, "control", Role::uxv).with_node("drive_container"), ticker_,
                entry_of);
  ASSERT_TRUE(sut.load("fragile", "arm", "").done);
  EXPECT_EQ(sut.all().front().component->node(), "arm");
}

TEST_F(InstancesTest, RefusesASecondNodeOfOneName) {
  EXPECT_TRUE(sut_.load("fragile", "a", "").done);
  const Outcome outcome = sut_.load("fragile", "a", "");
  EXPECT_FALSE(outcome.done);
  EXPECT_THAT(outcome.text, HasSubstr("two nodes of one name"));
}

TEST_F(InstancesTest, RefusesAnUnknownComponentAndWrongParametersWithoutATrace) {
  EXPECT_THAT(sut_.load("fragil", "a", "").text, HasSubstr("component 'fragil': no library"));
  EXPECT_THAT(sut_.load("fragile", "a", "{in_tik: true}").text, HasSubstr("unknown key"));
  EXPECT_THAT(sut_.load("fragile", "a", "{").text, HasSubstr("not valid YAML"));
  EXPECT_TRUE(sut_.all().empty());
}

// It is part of file names and of topics.
TEST_F(InstancesTest, RefusesANodeNameThatIsNoName) {
  for (const char* name : {"../a", "a/b", "", "A", "a\n"}) {
    EXPECT_THAT(sut_.load("fragile", name, "").text, HasSubstr("is not a name")) << name;
  }
  EXPECT_TRUE(sut_.all().empty());
}

TEST_F(InstancesTest, RefusesParametersThatStandForThemselves) {
  EXPECT_THAT(sut_.load("fragile", "a", "{in_tick: &x [*x]}").text,
              HasSubstr("the command: an alias within what it stands for"));
  EXPECT_TRUE(sut_.all().empty());
}

TEST_F(InstancesTest, AConstructorThatThrowsAtRunTimeIsAnErrorOfThatInstanceOnly) {
  EXPECT_TRUE(sut_.load("fragile", "good", "").done);
  EXPECT_THAT(sut_.load("fragile", "bad", "{at_start: true}").text, HasSubstr("no device"));
  EXPECT_EQ(state("bad"), LifecycleState::error);
  EXPECT_EQ(state("good"), LifecycleState::active);
}

TEST_F(InstancesTest, AConstructorThatThrowsAtStartUpThrowsOn) {
  const auto wrong = std::make_shared<const YAML::Node>(YAML::Load("{at_start: true}"));
  EXPECT_THROW(sut_.add("fragile", "bad", wrong, "file"), std::runtime_error);
}

TEST_F(InstancesTest, ATickThatThrowsIsAnErrorOfThatInstanceOnly) {
  EXPECT_TRUE(sut_.load("fragile", "bad", "{in_tick: true}").done);
  EXPECT_TRUE(sut_.load("fragile", "good", "").done);
  ticker_.tick_all();
  EXPECT_TRUE(sut_.settle_failures());
  EXPECT_FALSE(sut_.settle_failures());
  EXPECT_EQ(state("bad"), LifecycleState::error);
  EXPECT_EQ(sut_.all().front().error, "broken");
  EXPECT_EQ(state("good"), LifecycleState::active);
  EXPECT_EQ(ticker_.size(), 1U);
}

TEST_F(InstancesTest, AnInactiveComponentIsNeitherTickedNorSupplied) {
  EXPECT_TRUE(sut_.load("fragile", "a", "").done);
  EXPECT_TRUE(sut_.change("a", Transition::deactivate).done);
  bus_.publish<topic::Goal>({});
  ticker_.tick_all();
  EXPECT_EQ(component("a").ticks, 0);
  EXPECT_TRUE(sut_.change("a", Transition::activate).done);
  ticker_.tick_all();
  EXPECT_EQ(component("a").ticks, 1);
  EXPECT_EQ(component("a").taken, 0);
}

TEST_F(InstancesTest, CleanupDestroysAndConfigureConstructsAgain) {
  EXPECT_TRUE(sut_.load("fragile", "a", "").done);
  EXPECT_TRUE(sut_.change("a", Transition::deactivate).done);
  EXPECT_TRUE(sut_.change("a", Transition::cleanup).done);
  EXPECT_EQ(sut_.all().front().component, nullptr);
  EXPECT_TRUE(sut_.change("a", Transition::configure).done);
  EXPECT_EQ(state("a"), LifecycleState::inactive);
}

TEST_F(InstancesTest, ATransitionThatIsNotAllowedNamesTheState) {
  EXPECT_TRUE(sut_.load("fragile", "a", "").done);
  EXPECT_EQ(sut_.change("a", Transition::cleanup).text,
            "a: cleanup is not allowed from the state active");
  EXPECT_THAT(sut_.change("b", Transition::cleanup).text, HasSubstr("no component of this name"));
}

TEST_F(InstancesTest, UnloadsByNameAndById) {
  EXPECT_TRUE(sut_.load("fragile", "a", "").done);
  EXPECT_TRUE(sut_.load("fragile", "b", "").done);
  EXPECT_EQ(sut_.unload("a").text, "Unloaded component 1");
  EXPECT_EQ(sut_.unload("2").text, "Unloaded component 2");
  EXPECT_FALSE(sut_.unload("a").done);
  EXPECT_EQ(ticker_.size(), 0U);
}

TEST_F(InstancesTest, ABlockedComponentStaysAndSaysSo) {
  EXPECT_TRUE(sut_.load("fragile", "a", "").done);
  ticker_.stuck = true;
  EXPECT_THAT(sut_.unload("a").text, HasSubstr("its tick does not end"));
  EXPECT_THAT(sut_.change("a", Transition::deactivate).text, HasSubstr("its tick does not end"));
  EXPECT_EQ(state("a"), LifecycleState::active);
  ticker_.stuck = false;
}

}  // namespace
}  // namespace tocsin
