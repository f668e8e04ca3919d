// SPDX-License-Identifier: Apache-2.0
// Services between components, on the bus of component tests.
#include "runtime/service_port.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "ros_idl/std_srvs.hpp"
#include "runtime/host_control.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

struct Lamp {
  using Request = std_srvs::srv::SetBool_Request;
  using Response = std_srvs::srv::SetBool_Response;
  static constexpr const char* name = "lamp/set";
};
/// Its own service of each node.
struct OwnLamp : Lamp {
  static constexpr const char* name = "~/set";
};

/// Serves, as soon as it may.
template <class Service>
class Server1 : public Component {
 public:
  explicit Server1(Context& context) : Component(context) {}
  void tick(Time) override {
    while (auto call = server_.take()) waiting_.push_back(*call);
    while (answers && !waiting_.empty()) {
      std_srvs::srv::SetBool_Response response;
      response.success(waiting_.front().request->data());
      response.message(name());
      server_.reply(waiting_.front().id, response);
      waiting_.erase(waiting_.begin());
    }
  }
  bool answers = true;
  [[nodiscard]] std::size_t waiting() const { return waiting_.size(); }

 private:
  Server<Service> server_{*this};
  std::vector<typename Server<Service>::Call> waiting_;
};
using LampServer = Server1<Lamp>;

/// Keeps all outcomes.
class Caller : public Component {
 public:
  explicit Caller(Context& context) : Component(context) {}
  void tick(Time now) override {
    now_ = now;
    while (auto outcome = client_.take(now)) outcomes.push_back(*outcome);
  }
  CallNumber call(bool on, Duration patience) {
    std_srvs::srv::SetBool_Request request;
    request.data(on);
    return client_.call(request, bus().now() + patience);
  }
  [[nodiscard]] bool available() const { return client_.available(); }
  std::vector<Client<Lamp>::Outcome> outcomes;

 private:
  Client<Lamp> client_{*this};
  Time now_{};
};

class ServicePortTest : public ::testing::Test {
 protected:
  SimBus bus_;
  Context server_context_{bus_, "server", Role::uxv};
  Context caller_context_{bus_, "caller", Role::uxv};
};

TEST_F(ServicePortTest, ACallIsAnsweredWithItsOwnNumber) {
  LampServer server(server_context_);
  Caller sut(caller_context_);
  bus_.add(server);
  bus_.add(sut);
  const CallNumber first = sut.call(true, seconds(1));
  const CallNumber second = sut.call(false, seconds(1));
  bus_.run_for(Duration::zero());
  ASSERT_EQ(sut.outcomes.size(), 2U);
  EXPECT_EQ(sut.outcomes[0].call, first);
  EXPECT_TRUE(sut.outcomes[0].response->success());
  EXPECT_EQ(sut.outcomes[1].call, second);
  EXPECT_FALSE(sut.outcomes[1].response->success());
}

TEST_F(ServicePortTest, AServerMayAnswerInALaterTick) {
  LampServer server(server_context_);
  Caller sut(caller_context_);
  bus_.add(server);
  bus_.add(sut);
  server.answers = false;
  (void)sut.call(true, seconds(5));
  bus_.run_for(seconds(1));
  EXPECT_EQ(server.waiting(), 1U);
  EXPECT_TRUE(sut.outcomes.empty());
  server.answers = true;
  server.schedule().input_arrived();
  bus_.run_for(Duration::zero());
  ASSERT_EQ(sut.outcomes.size(), 1U);
  EXPECT_NE(sut.outcomes[0].response, nullptr);
}

TEST_F(ServicePortTest, WithoutAnswerTheOutcomeComesAtTheDeadlineAndNotBefore) {
  Caller sut(caller_context_);
  bus_.add(sut);
  const CallNumber call = sut.call(true, seconds(2));
  bus_.run_for(seconds(2) - Duration(1));
  EXPECT_TRUE(sut.outcomes.empty());
  bus_.run_for(Duration(1));
  ASSERT_EQ(sut.outcomes.size(), 1U);
  EXPECT_EQ(sut.outcomes[0].call, call);
  EXPECT_EQ(sut.outcomes[0].response, nullptr);
  bus_.run_for(seconds(5));
  EXPECT_EQ(sut.outcomes.size(), 1U);
}

TEST_F(ServicePortTest, AnAnswerAfterTheDeadlineIsDropped) {
  LampServer server(server_context_);
  Caller sut(caller_context_);
  bus_.add(server);
  bus_.add(sut);
  server.answers = false;
  (void)sut.call(true, seconds(1));
  bus_.run_for(seconds(1));
  ASSERT_EQ(sut.outcomes.size(), 1U);
  server.answers = true;
  server.schedule().input_arrived();
  bus_.run_for(seconds(1));
  EXPECT_EQ(sut.outcomes.size(), 1U);
}

TEST_F(ServicePortTest, ACallWaitsForAServerThatComesBeforeItsDeadline) {
  Caller sut(caller_context_);
  bus_.add(sut);
  (void)sut.call(true, seconds(5));
  bus_.run_for(seconds(1));
  EXPECT_FALSE(sut.available());
  LampServer server(server_context_);
  bus_.add(server);
  bus_.run_for(Duration::zero());
  EXPECT_TRUE(sut.available());
  ASSERT_EQ(sut.outcomes.size(), 1U);
  EXPECT_NE(sut.outcomes[0].response, nullptr);
}

TEST_F(ServicePortTest, AServiceOfANodeIsUnderItsName) {
  Server1<OwnLamp> lamp(server_context_);
  bus_.add(lamp);
  Caller other(caller_context_);
  EXPECT_FALSE(other.available());
  const ServiceEndpoint own{"~/set", nullptr, nullptr, "lamp"};
  EXPECT_EQ(service_name(own), "lamp/set");
  EXPECT_EQ(service_name({"set", nullptr, nullptr, "lamp"}), "set");
  Context lamp_context{bus_, "lamp", Role::uxv};
  Server1<OwnLamp> named(lamp_context);
  EXPECT_TRUE(other.available());
}

TEST_F(ServicePortTest, AServerThatIsNotTakenFromKeepsTheNewestRequests) {
  Context context{bus_, "lamp", Role::uxv};
  class Idle : public Component {
   public:
    explicit Idle(Context& home) : Component(home) {}
    void tick(Time) override {}
    Server<Lamp> server{*this};
  } idle(context);
  Caller sut(caller_context_);
  for (int i = 0; i < 12; ++i) (void)sut.call(i >= 10, seconds(1));
  std::vector<bool> taken;
  while (auto call = idle.server.take()) taken.push_back(call->request->data());
  ASSERT_EQ(taken.size(), 10U);
  EXPECT_FALSE(taken.front());
  EXPECT_TRUE(taken.back());
}

TEST_F(ServicePortTest, TheBusTellsWhichServicesAreCalled) {
  EXPECT_TRUE(bus_.host_control().callers().services.empty());
  Caller sut(caller_context_);
  EXPECT_EQ(bus_.host_control().callers().services, std::vector<std::string>{"lamp/set"});
}

}  // namespace
}  // namespace tocsin
