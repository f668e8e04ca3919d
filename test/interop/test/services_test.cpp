// SPDX-License-Identifier: Apache-2.0
// Requests and replies as rmw_fastrtps and rmw_cyclonedds send them, against our ends. None of the
// two is installed here: what they send is stated in runtime's service_wire.hpp and service_ends,
// and made here by each maker's own library.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <mutex>

#include "lamp_service.hpp"
#include "ros_idl/std_srvs.hpp"
#include "runtime/fast_dds/names.hpp"
#include "runtime/middleware/host_graph.hpp"
#include "within.hpp"

namespace tocsin::interop {
namespace {

using Request = std_srvs::srv::SetBool_Request;
using Response = std_srvs::srv::SetBool_Response;

const ServiceEndpoint lamp{"lamp/set", &type_info<Request>(), &type_info<Response>()};

int next_domain() {
  static int last = 119;
  return ++last;
}

BusOptions options(int domain) {
  BusOptions options;
  options.name = "services";
  options.host_domain = domain;
  return options;
}

/// Our server: whoever asks for true is told that it is on.
class Lamp : public ServerReceiver {
 public:
  explicit Lamp(Bus& bus) : end_(bus.serve(lamp, *this)) {}
  void receive(ServiceRequest&& request) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    requests_.push_back(std::move(request));
  }
  void wake() override {}
  void answer() {
    end_->flush();
    const std::lock_guard<std::mutex> lock(mutex_);
    for (; !requests_.empty(); requests_.pop_front()) {
      const auto& request = requests_.front();
      auto response = std::make_shared<Response>();
      response->success(std::static_pointer_cast<const Request>(request.message)->data());
      response->message(response->success() ? "on" : "off");
      end_->reply(request.id, response);
      ++answered;
    }
  }
  int answered = 0;

 private:
  std::mutex mutex_;
  std::deque<ServiceRequest> requests_;
  std::unique_ptr<ServerEnd> end_;
};

/// Our client.
class Asker : public ClientReceiver {
 public:
  explicit Asker(Bus& bus) : end_(bus.call(lamp, *this)) {}
  void receive(ServiceReply&& reply) override {
    const std::lock_guard<std::mutex> lock(mutex_);
    replies_.push_back(std::move(reply));
  }
  void wake() override {}
  [[nodiscard]] bool available() const { return end_->available(); }
  std::optional<std::int64_t> ask() {
    auto request = std::make_shared<Request>();
    request->data(true);
    return end_->send(request);
  }
  std::vector<ServiceReply> replies() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return replies_;
  }

 private:
  std::mutex mutex_;
  std::vector<ServiceReply> replies_;
  std::unique_ptr<ClientEnd> end_;
};

TEST(Services, AClientOfRmwCycloneddsIsAnsweredWithItsHeader) {
  const int domain = next_domain();
  const auto bus = make_fast_dds_bus(options(domain));
  const auto raw = make_host_graph(options(domain));
  std::mutex mutex;
  Bytes heard;
  const auto reading = raw->read({replies.topic, replies.type, true}, [&](RawSample&& sample) {
    const std::lock_guard<std::mutex> lock(mutex);
    heard = *sample.bytes;
  });
  Lamp sut(*bus);
  CycloneClient client(domain);
  ASSERT_TRUE(eventually([&] { return client.is_connected(); }));
  client.write({0x1122334455667788, 42, true});
  bool came = false;
  ASSERT_TRUE(eventually([&] {
    sut.answer();
    client.take([&](const headed_SetBoolResponse& reply) {
      came = true;
      EXPECT_EQ(reply.client, 0x1122334455667788U);
      EXPECT_EQ(reply.number, 42);
      EXPECT_TRUE(reply.success);
      EXPECT_STREQ(reply.message, "on");
    });
    return came;
  }));
  Bytes expected{0,    1,    0,  0, 0x88, 0x77, 0x66, 0x55, 0x44, 0x33,
                 0x22, 0x11, 42, 0, 0,    0,    0,    0,    0,    0};
  expected.insert(expected.end(), response_bytes.begin() + 4, response_bytes.end());
  EXPECT_TRUE(eventually([&] {
    const std::lock_guard<std::mutex> lock(mutex);
    return heard == padded(expected);
  }));
}

TEST(Services, ClientsOfBothAreServedSideBySideAndNeitherTakesTheOthersReply) {
  const int domain = next_domain();
  const auto bus = make_fast_dds_bus(options(domain));
  Lamp sut(*bus);
  FastDdsService fast(domain, requests, replies);
  CycloneClient cyclone(domain);
  ASSERT_TRUE(eventually([&] { return fast.is_connected() && cyclone.is_connected(); }));
  FastDdsService::Identity asked;
  asked.writer_guid(fast.reader_guid());  // and no number, which the request's own stands for
  std::vector<std::int64_t> numbers;
  for (int i = 0; i < 5; ++i) {
    numbers.push_back(fast.write(request_bytes, asked));
    cyclone.write({7, 100 + i, i % 2 == 0});
  }
  std::vector<std::int64_t> of_fast;
  std::vector<std::int64_t> of_cyclone;
  ASSERT_TRUE(eventually([&] {
    sut.answer();
    while (const auto reply = fast.take()) {
      if (reply->related.writer_guid() != fast.reader_guid()) continue;  // as rmw_fastrtps
      EXPECT_EQ(reply->bytes, padded(response_bytes));
      of_fast.push_back(reply->related.sequence_number().to64long());
    }
    cyclone.take([&](const headed_SetBoolResponse& reply) {
      if (reply.client != 7) return;  // as rmw_cyclonedds
      EXPECT_EQ(reply.success, (reply.number - 100) % 2 == 0);
      of_cyclone.push_back(reply.number);
    });
    return of_fast.size() == 5 && of_cyclone.size() == 5;
  }));
  EXPECT_EQ(of_fast, numbers);
  EXPECT_EQ(of_cyclone, (std::vector<std::int64_t>{100, 101, 102, 103, 104}));
  EXPECT_EQ(sut.answered, 10);
}

TEST(Services, OurClientAsksAServerOfRmwFastrtpsByIdentity) {
  const int domain = next_domain();
  const auto bus = make_fast_dds_bus(options(domain));
  FastDdsService server(domain, replies, requests);
  Asker sut(*bus);
  ASSERT_TRUE(eventually([&] { return sut.available() && server.is_connected(); }));
  const auto number = sut.ask();
  ASSERT_TRUE(number);
  std::optional<FastDdsService::Taken> request;
  ASSERT_TRUE(eventually([&] { return (request = server.take()).has_value(); }));
  EXPECT_EQ(request->bytes, padded(request_bytes));
  EXPECT_NE(request->related.writer_guid(), eprosima::fastdds::rtps::GUID_t::unknown());
  // rmw_fastrtps answers so: the guid that was given, and the number of the request's sample.
  FastDdsService::Identity answered = request->related;
  answered.sequence_number(request->identity.sequence_number());
  (void)server.write(response_bytes, answered);
  ASSERT_TRUE(eventually([&] { return sut.replies().size() == 1; }));
  EXPECT_EQ(sut.replies()[0].number, *number);
}

TEST(Services, OurClientAsksAServerOfRmwCycloneddsWithAHeader) {
  const int domain = next_domain();
  const auto bus = make_fast_dds_bus(options(domain));
  CycloneServer server(domain);
  Asker sut(*bus);
  ASSERT_TRUE(eventually([&] { return sut.available() && server.is_connected(); }));
  const auto number = sut.ask();
  ASSERT_TRUE(number);
  std::string text = "on";
  EXPECT_TRUE(eventually([&] {
    server.take([&](const headed_SetBoolRequest& request) {
      EXPECT_TRUE(request.data);
      server.write({request.client + 1, request.number, true, text.data()});  // another's
      server.write({request.client, request.number, true, text.data()});
    });
    return !sut.replies().empty();
  }));
  ASSERT_EQ(sut.replies().size(), 1U);
  EXPECT_EQ(sut.replies()[0].number, *number);
  EXPECT_EQ(std::static_pointer_cast<const Response>(sut.replies()[0].message)->message(), "on");
}

}  // namespace
}  // namespace tocsin::interop
