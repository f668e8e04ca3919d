// SPDX-License-Identifier: Apache-2.0
// `tocsin action` as a user runs it, on real DDS, beside a node that computes Fibonacci's numbers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "command_line/run_to_end.hpp"
#include "idl_support/action_types.hpp"
#include "ros_idl/example_interfaces.hpp"
#include "runtime/action_port.hpp"
#include "ticked_neighbour.hpp"

namespace tocsin::topic_tool {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;
namespace wire = example_interfaces::action;

constexpr int domain = 128;

struct Fibonacci
    : ActionTypes<wire::Fibonacci_SendGoal_Request, wire::Fibonacci_SendGoal_Response,
                  wire::Fibonacci_GetResult_Request, wire::Fibonacci_GetResult_Response,
                  wire::Fibonacci_FeedbackMessage> {
  static constexpr const char* name = "fibonacci";
};

/// A number in each 20 ms, the first after 0.2 s; an order of 0 is rejected.
class Counter : public Component {
 public:
  explicit Counter(Context& context) : Component(context) {}
  void tick(Time now) override {
    while (const auto asked = server_.take(now)) {
      if (asked->goal->order() < 1) {
        wire::Fibonacci_Result why;
        if (asked->goal->order() < 0) why.sequence({asked->goal->order()});
        server_.reject(why);
        continue;
      }
      server_.accept(now);
      running_[asked->id] = {asked->goal->order(), {0, 1}, now + seconds(0.2)};
      is_running = true;
    }
    for (auto it = running_.begin(); it != running_.end();) {
      it = step(it->first, it->second, now) ? running_.erase(it) : std::next(it);
    }
  }
  std::atomic<bool> is_running{false};
  std::atomic<bool> was_canceled{false};

 private:
  struct Work {
    int order;
    std::vector<std::int32_t> sequence;
    Time next;
  };
  bool step(const GoalId& id, Work& work, Time now) {
    wire::Fibonacci_Result result;
    result.sequence(work.sequence);
    if (server_.is_canceling(id)) {
      server_.canceled(id, result, now);
      was_canceled = true;
      return true;
    }
    if (now < work.next) return false;
    work.next = now + seconds(0.02);
    auto& all = work.sequence;
    if (static_cast<int>(all.size()) > work.order) {
      server_.succeed(id, result, now);
      return true;
    }
    if (all.size() < 40) all.push_back(all[all.size() - 1] + all[all.size() - 2]);
    wire::Fibonacci_Feedback feedback;
    feedback.sequence(all);
    server_.feedback(id, feedback);
    return false;
  }
  ActionServer<Fibonacci> server_{*this};
  std::map<GoalId, Work> running_;
};

Ended action(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), ACTION_PROGRAM);
  arguments.insert(arguments.end(), {"--domain", std::to_string(domain)});
  return run_to_end(arguments);
}

class ActionProgram : public ::testing::Test {
 protected:
  static Ended send(const std::string& goal, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"send_goal", "/fibonacci",
                                       "example_interfaces/action/Fibonacci", goal};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return action(arguments);
  }
  TickedNeighbour<Counter> neighbour_{domain, "counter"};
};

TEST_F(ActionProgram, ListsActionsAndWhoHasThem) {
  EXPECT_EQ(action({"list"}).output, "/fibonacci\n");
  EXPECT_EQ(action({"list", "-t"}).output, "/fibonacci [example_interfaces/action/Fibonacci]\n");
  EXPECT_EQ(action({"info", "fibonacci"}).output,
            "Action: /fibonacci\nAction clients: 0\nAction servers: 1\n    /counter\n");
  EXPECT_EQ(action({"type", "/fibonacci"}).output, "example_interfaces/action/Fibonacci\n");
}

TEST_F(ActionProgram, SendsAGoalAndPrintsItsWay) {
  const Ended sut = send("{order: 3}", {"--feedback"});
  EXPECT_EQ(sut.code, 0);
  EXPECT_THAT(sut.output, StartsWith("Waiting for an action server to become available...\n"
                                     "Sending goal:\n     order: 3\n\nGoal accepted with ID: "));
  EXPECT_THAT(sut.output, HasSubstr("Feedback:\n    sequence:\n- 0\n- 1\n- 1\n\n"));
  EXPECT_THAT(sut.output, HasSubstr("Result:\n    sequence:\n- 0\n- 1\n- 1\n- 2\n\n"
                                    "Goal finished with status: SUCCEEDED\n"));
}

TEST_F(ActionProgram, AGoalThatIsRejectedIsNoSuccess) {
  const Ended sut = send("{order: 0}");
  EXPECT_EQ(sut.code, 1);
  EXPECT_THAT(sut.output, EndsWith("Goal was rejected.\n"));
  EXPECT_THAT(send("{order: -3}").output,
              HasSubstr("Goal was rejected.\nResult:\n    sequence:\n- -3\n"))
      << "a reason is shown";
}

TEST_F(ActionProgram, CtrlCCancelsTheGoal) {
  const Ended sut =
      run_to_end({"/usr/bin/timeout", "--signal=INT", "--preserve-status", "2", ACTION_PROGRAM,
                  "send_goal", "/fibonacci", "example_interfaces/action/Fibonacci",
                  "{order: 1000000}", "--domain", std::to_string(domain)});
  EXPECT_TRUE(neighbour_.component().is_running);
  EXPECT_THAT(sut.output, HasSubstr("Canceling goal...\nGoal canceled.\n"));
  for (int i = 0; i < 200 && !neighbour_.component().was_canceled; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  EXPECT_TRUE(neighbour_.component().was_canceled);
}

TEST_F(ActionProgram, SaysInOneLineWhatIsWrong) {
  const Ended field = send("{ordre: 3}");
  EXPECT_EQ(field.code, 2);
  EXPECT_THAT(field.output, HasSubstr("no field 'ordre'"));
  const Ended nobody = action({"send_goal", "/nothing", "example_interfaces/action/Fibonacci",
                               "{order: 1}", "--timeout", "0.3"});
  EXPECT_EQ(nobody.code, 1);
  EXPECT_THAT(nobody.output, HasSubstr("service /nothing/_action/send_goal: nobody serves it\n"));
  EXPECT_EQ(action({"info", "/nothing"}).code, 1);
  EXPECT_THAT(action({"info", "/fibonaci"}).output,
              HasSubstr("is not there; did you mean '/fibonacci'?\n"));
  const Ended misspelt = action({"send_goal", "/fibonaci", "example_interfaces/action/Fibonacci",
                                 "{order: 1}", "--timeout", "0.3"});
  EXPECT_EQ(misspelt.code, 1);
  EXPECT_THAT(misspelt.output, HasSubstr("nobody serves it; did you mean '/fibonacci'?\n"));
}

}  // namespace
}  // namespace tocsin::topic_tool
