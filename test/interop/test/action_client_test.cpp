// SPDX-License-Identifier: Apache-2.0
// Our client of an action against a server as rclcpp's over rmw_fastrtps, whose bytes are written
// down here.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fibonacci.hpp"
#include "runtime/action_port.hpp"
#include "within.hpp"

namespace tocsin::interop {
namespace {

using ::testing::ElementsAre;
using What = ActionClient<Fibonacci>::What;

/// A server's half of a service, as rmw_fastrtps has it.
class FastServer : public FastDdsService {
 public:
  using FastDdsService::FastDdsService;
  std::optional<Taken> next() { return take(); }
  void answer(const Taken& request, const Bytes& bytes) {
    Identity answered = request.related;
    answered.sequence_number(request.identity.sequence_number());
    (void)write(bytes, answered);
  }
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

std::optional<FastDdsService::Taken> request_to(FastServer& server, Asker& asker, Bus& bus) {
  std::optional<FastDdsService::Taken> request;
  EXPECT_TRUE(eventually([&] {
    asker.tick(bus.now());
    return (request = server.next()).has_value();
  }));
  return request;
}

void expect_success(const std::vector<ActionClient<Fibonacci>::News>& news) {
  EXPECT_EQ(news[0].what, What::accepted);
  EXPECT_EQ(news[1].what, What::feedback);
  EXPECT_THAT(news[1].feedback->sequence(), ElementsAre(5));
  EXPECT_EQ(news[2].state, GoalState::succeeded);
  EXPECT_THAT(news[2].result->sequence(), ElementsAre(5));
}

TEST(OurClient, HasAServerOfRmwFastrtpsWorkOnItsGoal) {
  constexpr int domain = 145;
  const auto bus = make_fast_dds_bus(host(domain, "action_client"));
  const auto graph = make_host_graph(host(domain, "action_client"));
  Context context{*bus, "asker", Role::uxv};
  Asker sut(context);
  FastServer goals(domain, goal_reply, goal_request);
  FastServer results(domain, result_reply, result_request);
  FastServer cancels(domain, cancel_reply, cancel_request);
  const auto feedback = graph->write(feedback_topic);
  ASSERT_TRUE(eventually([&] {
    return sut.client.available() && goals.is_connected() && results.is_connected() &&
           feedback->readers() == 1;
  }));
  wire::Fibonacci_Goal goal;
  goal.order(3);
  const GoalId sent = sut.client.send(goal, bus->now() + seconds(15), bus->now() + seconds(15));
  const Bytes its_id(sent.begin(), sent.end());
  const auto asked = request_to(goals, sut, *bus);
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->bytes, joined({its_id, order_3}));
  goals.answer(*asked, joined({{1, 0, 0, 0}, Bytes(8, 1)}));
  const auto wanted = request_to(results, sut, *bus);
  ASSERT_TRUE(wanted);
  EXPECT_EQ(wanted->bytes, joined({its_id}));
  const Bytes one_number{1, 0, 0, 0, 5, 0, 0, 0};
  ASSERT_TRUE(feedback->write(joined({id, one_number})));  // of another's goal
  ASSERT_TRUE(feedback->write(joined({its_id, one_number})));
  const auto has_news = [&](std::size_t wanted_news) {
    return eventually([&] {
      sut.tick(bus->now());
      return sut.news.size() == wanted_news;
    });
  };
  ASSERT_TRUE(has_news(2));
  results.answer(*wanted, joined({{4, 0, 0, 0}, one_number}));
  ASSERT_TRUE(has_news(3));
  expect_success(sut.news);
}

}  // namespace
}  // namespace tocsin::interop
