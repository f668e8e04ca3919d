// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/container_client.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

using State = ContainerClient::State;
using Command = ContainerClient::Command;
using Answer = ContainerClient::Answer;
using ::testing::ElementsAre;

/// Hands what is written to the test, and what the test says to the subscriber.
class ScriptedBus : public Bus {
 public:
  std::unique_ptr<Subscription> subscribe(const Endpoint&, Receiver& receiver) override {
    receiver_ = &receiver;
    return std::make_unique<Subscription>();
  }
  std::unique_ptr<Publication> advertise(const Endpoint&) override {
    return std::make_unique<Writer>(*this);
  }
  [[nodiscard]] Time now() const override { return {}; }
  [[nodiscard]] std::int64_t wall_ns(Time) const override { return 0; }

  void say(const State& state) {
    Sample sample;
    sample.message = std::make_shared<const State>(state);
    receiver_->receive(sample);
  }
  std::function<void(const Command&)> on_command = [](const Command&) {};

 private:
  class Writer : public Publication {
   public:
    explicit Writer(ScriptedBus& bus) : bus_(bus) {}
    Status write(const std::shared_ptr<const void>& message) override {
      bus_.on_command(*std::static_pointer_cast<const Command>(message));
      return Status::ok;
    }

   private:
    ScriptedBus& bus_;
  };
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

State with_answer(State state, std::uint64_t id, const std::string& text) {
  Answer answer;
  answer.id(id);
  answer.done(true);
  answer.text(text);
  state.answers().push_back(answer);
  return state;
}

ContainerClient::Known known_to(ContainerClient& client) {
  return client.wait(Duration::zero(), [](const auto&) { return true; });
}

TEST(ContainerClient, KnowsTheNewestStateOfEachProcess) {
  ScriptedBus bus;
  ContainerClient sut(bus);
  bus.say(state_of("drive", 1, "old"));
  bus.say(state_of("drive", 1, "new"));
  bus.say(state_of("drive", 2, "twin"));
  const auto known = known_to(sut);
  ASSERT_EQ(known.size(), 2U);
  EXPECT_EQ(known.at({"drive", 1}).components().front().name(), "new");
}

TEST(ContainerClient, TellsThePathsOfContainersAndInstancesEachOnce) {
  ScriptedBus bus;
  ContainerClient sut(bus);
  bus.say(state_of("link", 1, "monitor"));
  bus.say(state_of("drive", 2, "navigator"));
  bus.say(state_of("drive", 3, "navigator"));  // a twin
  EXPECT_THAT(container_paths(known_to(sut)), ElementsAre("uxv/drive", "uxv/link"));
  EXPECT_THAT(instance_paths(known_to(sut)),
              ElementsAre("uxv/drive/navigator", "uxv/link/monitor"));
}

TEST(ContainerClient, TakesTheAnswerToItsOwnCommandOnly) {
  ScriptedBus bus;
  ContainerClient sut(bus);
  bus.on_command = [&](const Command& command) {
    bus.say(with_answer(state_of("other", 1, "x"), command.id() + 1, "to somebody else"));
    bus.say(with_answer(state_of("drive", 2, "y"), command.id(), "yes"));
  };
  EXPECT_EQ(sut.ask(Command(), seconds(5)).text(), "yes");
}

TEST(ContainerClient, RepeatsACommandUnderOneIdUntilItIsAnswered) {
  ScriptedBus bus;
  ContainerClient sut(bus);
  std::vector<std::uint64_t> ids;
  bus.on_command = [&](const Command& command) {
    ids.push_back(command.id());
    if (ids.size() == 2) bus.say(with_answer(state_of("drive", 1, "x"), command.id(), "late"));
  };
  EXPECT_EQ(sut.ask(Command(), seconds(5)).text(), "late");
  ASSERT_EQ(ids.size(), 2U);
  EXPECT_EQ(ids[0], ids[1]);
}

TEST(ContainerClient, AContainerThatDoesNotAnswerIsAnEnvironmentErrorThatNamesIt) {
  ScriptedBus bus;
  ContainerClient sut(bus);
  Command command;
  command.container("drive");
  command.verb("unload");
  try {
    (void)sut.ask(command, seconds(0.1));
    FAIL();
  } catch (const EnvironmentError& error) {
    EXPECT_STREQ(error.what(), "container drive: no answer to unload within 0 s");
  }
}

}  // namespace
}  // namespace tocsin
