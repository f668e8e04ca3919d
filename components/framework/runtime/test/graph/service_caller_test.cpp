// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/service_caller.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <thread>

#include "foundation/error.hpp"
#include "ros_idl/std_srvs.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;
using Request = std_srvs::srv::SetBool_Request;
using Response = std_srvs::srv::SetBool_Response;

/// A host on which one service is, or is not, and answers, or does not.
class ToyGraph final : public HostGraph {
 public:
  bool serves = true;
  bool answers = true;
  std::vector<std::string> called = {};

  [[nodiscard]] std::vector<GraphEnd> ends() const override { return {}; }
  [[nodiscard]] std::vector<GraphNode> nodes() const override { return {}; }
  [[nodiscard]] std::unique_ptr<RawReading> read(const RawTopic&,
                                                 std::function<void(RawSample&&)>) override {
    return nullptr;
  }
  [[nodiscard]] std::unique_ptr<RawWriting> write(const RawTopic&, const QosProfile&) override {
    return nullptr;
  }
  [[nodiscard]] std::unique_ptr<RawWriting> write(const RawTopic&) override { return nullptr; }
  [[nodiscard]] std::unique_ptr<ClientEnd> call(const ServiceEndpoint& endpoint,
                                                ClientReceiver& receiver) override {
    called.push_back(service_name(endpoint));
    return std::make_unique<End>(*this, receiver);
  }

 private:
  class End final : public ClientEnd {
   public:
    End(ToyGraph& graph, ClientReceiver& receiver) : graph_(graph), receiver_(receiver) {}
    ~End() override {
      if (thread_.joinable()) thread_.join();
    }
    End(const End&) = delete;
    End& operator=(const End&) = delete;
    std::optional<std::int64_t> send(const std::shared_ptr<const void>& message) override {
      const bool on = std::static_pointer_cast<const Request>(message)->data();
      if (graph_.answers) thread_ = std::thread([this, on] { answer(on); });
      return 7;
    }
    [[nodiscard]] bool available() const override { return graph_.serves; }

   private:
    /// Another's reply comes first.
    void answer(bool on) {
      auto response = std::make_shared<Response>();
      receiver_.receive({response, 6});
      auto own = std::make_shared<Response>();
      own->success(on);
      receiver_.receive({own, 7});
    }
    ToyGraph& graph_;
    ClientReceiver& receiver_;
    std::thread thread_;
  };
};

struct SetLamp {
  using Request = std_srvs::srv::SetBool_Request;
  using Response = std_srvs::srv::SetBool_Response;
  static constexpr const char* name = "~/set";
};

std::string error_of(ToyGraph& graph) {
  try {
    (void)call_service<SetLamp>(graph, "/lamp", {}, seconds(0.02));
  } catch (const EnvironmentError& error) {
    return error.what();
  }
  return "";
}

TEST(ServiceCallerTest, GivesTheAnswerToItsOwnCall) {
  ToyGraph graph;
  Request request;
  request.data(true);
  const auto response = call_service<SetLamp>(graph, "/uxv/lamp", request, seconds(10));
  EXPECT_TRUE(response->success());
  EXPECT_EQ(graph.called, std::vector<std::string>{"/uxv/lamp/set"});
}

TEST(ServiceCallerTest, SaysThatNobodyServes) {
  ToyGraph graph;
  graph.serves = false;
  EXPECT_THAT(error_of(graph), HasSubstr("service /lamp/set: nobody serves it"));
}

TEST(ServiceCallerTest, SaysThatNobodyAnswers) {
  ToyGraph graph;
  graph.answers = false;
  EXPECT_THAT(error_of(graph), HasSubstr("service /lamp/set: no answer"));
}

TEST(ServiceCallerTest, KnowsAtOnceThatAServerIsThere) {
  ToyGraph graph;
  ServiceCaller sut(graph, {"/lamp/set", &type_info<Request>(), &type_info<Response>()});
  EXPECT_TRUE(sut.wait_for_server(seconds(10)));
  graph.serves = false;
  EXPECT_FALSE(sut.wait_for_server(seconds(0.01)));
}

}  // namespace
}  // namespace tocsin
