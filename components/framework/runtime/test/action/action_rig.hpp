// SPDX-License-Identifier: Apache-2.0
// A component that works on goals, and one that sends them.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <vector>

#include "idl_support/action_types.hpp"
#include "ros_idl/example_interfaces.hpp"
#include "runtime/action_port.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {

namespace wire = example_interfaces::action;

struct Fibonacci
    : ActionTypes<wire::Fibonacci_SendGoal_Request, wire::Fibonacci_SendGoal_Response,
                  wire::Fibonacci_GetResult_Request, wire::Fibonacci_GetResult_Response,
                  wire::Fibonacci_FeedbackMessage> {
  static constexpr const char* name = "fibonacci";
};
struct StatusTopic {
  using Message = action_msgs::msg::GoalStatusArray;
  static constexpr TopicInfo info{"fibonacci/_action/status", "state", Scope::host};
};

/// Makes one number of the sequence in each second; an order of 0 is none, one below says so in its
/// result, one above 90 is given up.
class Counter : public Component {
 public:
  explicit Counter(Context& context) : Component(context) {}
  void tick(Time now) override {
    while (const auto asked = server_.take(now)) {
      if (asked->goal->order() < 1) {
        wire::Fibonacci_Result why;
        why.sequence({asked->goal->order()});
        if (asked->goal->order() < 0) server_.reject(why);
        continue;
      }
      server_.accept(now);
      running_[asked->id] = {asked->goal->order(), {0, 1}};
    }
    if (now >= next_) work(now);
    if (!running_.empty()) wake_at(next_);
  }

 private:
  struct Work {
    int order;
    std::vector<std::int32_t> sequence;
  };
  void work(Time now) {
    next_ = now + seconds(1);
    for (auto it = running_.begin(); it != running_.end();) {
      it = step(it->first, it->second, now) ? running_.erase(it) : std::next(it);
    }
  }
  bool step(const GoalId& id, Work& work, Time now) {
    auto& all = work.sequence;
    const auto result = [&all] {
      wire::Fibonacci_Result made;
      made.sequence(all);
      return made;
    };
    if (server_.is_canceling(id)) {
      server_.canceled(id, result(), now);
      return true;
    }
    if (work.order > 90) {
      server_.abort(id, result(), now);
      return true;
    }
    all.push_back(all[all.size() - 1] + all[all.size() - 2]);
    wire::Fibonacci_Feedback feedback;
    feedback.sequence(all);
    server_.feedback(id, feedback);
    if (static_cast<int>(all.size()) <= work.order) return false;
    server_.succeed(id, result(), now);
    return true;
  }
  ActionServer<Fibonacci> server_{*this};
  std::map<GoalId, Work> running_;
  Time next_{};
};

class Asker : public Component {
 public:
  explicit Asker(Context& context) : Component(context) {}
  void tick(Time now) override {
    while (auto one = client.take(now)) news.push_back(*one);
  }
  ActionClient<Fibonacci> client{*this};
  std::vector<ActionClient<Fibonacci>::News> news;
};

class ActionPortTest : public ::testing::Test {
 protected:
  ActionPortTest() { bus_.add(asker_); }
  void start_server() {
    counter_.emplace(counter_context_);
    bus_.add(*counter_);
  }
  GoalId send(int order, double answer_s = 1, double result_s = 100) {
    wire::Fibonacci_Goal goal;
    goal.order(order);
    return asker_.client.send(goal, bus_.now() + seconds(answer_s), bus_.now() + seconds(result_s));
  }
  std::vector<ActionClient<Fibonacci>::What> news_of(const GoalId& id) {
    std::vector<ActionClient<Fibonacci>::What> all;
    for (const auto& one : asker_.news) {
      if (one.id == id) all.push_back(one.what);
    }
    return all;
  }
  SimBus bus_;
  Context counter_context_{bus_, "counter", Role::uxv};
  Context asker_context_{bus_, "asker", Role::uxv};
  Asker asker_{asker_context_};
  std::optional<Counter> counter_;
};

}  // namespace tocsin
