// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/container_states.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tocsin {
namespace {

using State = ContainerStates::State;
using ::testing::ElementsAre;

/// Hands what the test says to the subscriber.
class ScriptedBus : public Bus {
 public:
  std::unique_ptr<Subscription> subscribe(const Endpoint&, Receiver& receiver) override {
    receiver_ = &receiver;
    return std::make_unique<Subscription>();
  }
  std::unique_ptr<Publication> advertise(const Endpoint&) override { return nullptr; }
  [[nodiscard]] Time now() const override { return {}; }
  [[nodiscard]] std::int64_t wall_ns(Time) const override { return 0; }

  void say(const State& state) {
    Sample sample;
    sample.message = std::make_shared<const State>(state);
    receiver_->receive(sample);
  }

 private:
  Receiver* receiver_ = nullptr;
};

State state_of(const std::string& container, int pid, const std::string& instance) {
  State state;
  state.host("uxv");
  state.container(container);
  state.pid(pid);
  state.components().emplace_back().name(instance);
  return state;
}

ContainerStates::Known known_to(ContainerStates& client) {
  return client.wait(Duration::zero(), [](const auto&) { return true; });
}

TEST(ContainerStates, KnowsTheNewestStateOfEachProcess) {
  ScriptedBus bus;
  ContainerStates sut(bus);
  bus.say(state_of("drive", 1, "old"));
  bus.say(state_of("drive", 1, "new"));
  bus.say(state_of("drive", 2, "twin"));
  const auto known = known_to(sut);
  ASSERT_EQ(known.size(), 2U);
  EXPECT_EQ(known.at({"drive", 1}).components().front().name(), "new");
}

TEST(ContainerStates, TellsThePathsOfContainersEachOnce) {
  ScriptedBus bus;
  ContainerStates sut(bus);
  bus.say(state_of("link", 1, "monitor"));
  bus.say(state_of("drive", 2, "navigator"));
  bus.say(state_of("drive", 3, "navigator"));  // a twin
  EXPECT_THAT(container_paths(known_to(sut)), ElementsAre("uxv/drive", "uxv/link"));
}

}  // namespace
}  // namespace tocsin
