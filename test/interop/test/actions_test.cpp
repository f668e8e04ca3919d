// SPDX-License-Identifier: Apache-2.0
// Goals, feedback, cancellation and results of actions as clients of rclcpp and rclpy send them
// over rmw_fastrtps, against our server. It is not installed here: the bytes are written down from
// the interface files and the layout of XCDR1. How rmw_cyclonedds frames services: services_test.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <mutex>

#include "fibonacci.hpp"
#include "runtime/action_port.hpp"
#include "within.hpp"

namespace tocsin::interop {
namespace {

int next_domain() {
  static int last = 139;
  return ++last;
}

/// Our server: one number with each call of `step`.
class Counter : public Component {
 public:
  explicit Counter(Context& context) : Component(context) {}
  void tick(Time now) override {
    while (const auto asked = server_.take(now)) {
      server_.accept(now);
      goal_ = asked->id;
      order_ = asked->goal->order();
    }
    if (!goal_ || !server_.is_canceling(*goal_)) return;
    server_.canceled(*goal_, result(), now);
    goal_.reset();
  }
  void step(Time now) {
    if (!goal_) return;
    numbers_.push_back(numbers_[numbers_.size() - 1] + numbers_[numbers_.size() - 2]);
    wire::Fibonacci_Feedback feedback;
    feedback.sequence(numbers_);
    server_.feedback(*goal_, feedback);
    if (static_cast<int>(numbers_.size()) <= order_) return;
    server_.succeed(*goal_, result(), now);
    goal_.reset();
  }

 private:
  [[nodiscard]] wire::Fibonacci_Result result() const {
    wire::Fibonacci_Result made;
    made.sequence(numbers_);
    return made;
  }
  ActionServer<Fibonacci> server_{*this};
  std::optional<GoalId> goal_;
  int order_ = 0;
  std::vector<std::int32_t> numbers_{0, 1};
};

/// Keeps what it reads, as bytes.
class Listener {
 public:
  Listener(HostGraph& graph, const RawTopic& topic)
      : reading_(graph.read(topic, [this](RawSample&& sample) {
          const std::lock_guard<std::mutex> lock(mutex_);
          samples_.push_back(*sample.bytes);
        })) {}
  std::vector<Bytes> samples() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return samples_;
  }

 private:
  std::mutex mutex_;
  std::vector<Bytes> samples_;
  std::unique_ptr<RawReading> reading_;
};

/// A client's half of a service, as rmw_fastrtps has it.
class FastClient : public FastDdsService {
 public:
  using FastDdsService::FastDdsService;
  void ask(const Bytes& bytes) {
    Identity asked;
    asked.writer_guid(reader_guid());
    (void)write(bytes, asked);
  }
};

class OurServer : public ::testing::Test {
 protected:
  /// What the client is answered.
  Bytes answer(FastClient& client, const Bytes& request) {
    client.ask(request);
    return answer(client);
  }
  Bytes answer(FastClient& client) {
    std::optional<FastDdsService::Taken> reply;
    EXPECT_TRUE(eventually([&] {
      sut_.tick(bus_->now());
      return (reply = client.take()).has_value();
    }));
    return reply ? reply->bytes : Bytes();
  }
  const int domain_ = next_domain();
  const std::unique_ptr<Bus> bus_ = make_fast_dds_bus(host(domain_, "actions"));
  const std::unique_ptr<HostGraph> graph_ = make_host_graph(host(domain_, "actions"));
  Context context_{*bus_, "counter", Role::uxv};
  Counter sut_{context_};
};

TEST_F(OurServer, WorksOnAGoalOfRmwFastrtps) {
  Listener feedback(*graph_, feedback_topic);
  Listener status(*graph_, status_topic);
  FastClient goals(domain_, goal_request, goal_reply);
  FastClient results(domain_, result_request, result_reply);
  ASSERT_TRUE(eventually([&] { return goals.is_connected() && results.is_connected(); }));
  ASSERT_TRUE(eventually([&] { return graph_->ends().size() >= 8; }));
  const Bytes accepted = answer(goals, joined({id, order_3}));
  ASSERT_EQ(accepted.size(), 16U);
  EXPECT_EQ(accepted[4], 1);
  EXPECT_NE(part(accepted, 8, 4), Bytes(4, 0)) << "the stamp";
  ASSERT_TRUE(eventually([&] { return !status.samples().empty(); }));
  // One goal: its id, the stamp that was told with the answer, EXECUTING.
  EXPECT_EQ(status.samples().back(), padded(joined({{1, 0, 0, 0}, id, part(accepted, 8, 8), {2}})));
  results.ask(joined({id}));
  ASSERT_TRUE(eventually([&] {
    if (feedback.samples().empty()) sut_.step(bus_->now());
    return !feedback.samples().empty();
  }));
  const Bytes told = feedback.samples().front();
  EXPECT_EQ(part(told, 0, 20), joined({id}));
  EXPECT_EQ(part(told, 24, 12), (Bytes{0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}));
  sut_.step(bus_->now());
  const Bytes result = answer(results);
  EXPECT_EQ(part(result, 0, 5), (Bytes{0, 1, 0, 0, 4})) << "SUCCEEDED";
  EXPECT_EQ(part(result, 12, 12), (Bytes{0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}));
}

TEST_F(OurServer, CancelsAGoalOfRmwFastrtps) {
  FastClient goals(domain_, goal_request, goal_reply);
  FastClient results(domain_, result_request, result_reply);
  FastClient cancels(domain_, cancel_request, cancel_reply);
  ASSERT_TRUE(eventually(
      [&] { return goals.is_connected() && results.is_connected() && cancels.is_connected(); }));
  const Bytes accepted = answer(goals, joined({id, {100, 0, 0, 0}}));
  ASSERT_EQ(accepted[4], 1);
  const Bytes no_stamp(8, 0);
  const Bytes canceling = answer(cancels, joined({id, no_stamp}));
  // ERROR_NONE; one goal with its id and the stamp of its acceptance.
  EXPECT_EQ(canceling, joined({{0, 0, 0, 0, 1, 0, 0, 0}, id, part(accepted, 8, 8)}));
  const Bytes result = answer(results, joined({id}));
  EXPECT_EQ(result, joined({{5, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0}})) << "CANCELED";
  const Bytes again = answer(cancels, joined({id, no_stamp}));
  EXPECT_EQ(again, joined({{3, 0, 0, 0, 0, 0, 0, 0}})) << "ERROR_GOAL_TERMINATED";
}

}  // namespace
}  // namespace tocsin::interop
