// SPDX-License-Identifier: Apache-2.0
// Clients that want too much, or the wrong thing, on real sockets.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <vector>

#include "foundation/error.hpp"
#include "foundation/file_descriptor.hpp"
#include "foundation/temporary_folder.hpp"
#include "listening_socket.hpp"
#include "served.hpp"

namespace tocsin {
namespace {

using ::testing::HasSubstr;
using Params = OperatorServerComponent::Params;

constexpr const char* secret = "0123456789abcdef";

/// A file with the secret.
std::string token_file(const TemporaryFolder& folder) {
  return folder.write("token", std::string(secret) + "\n");
}

/// A connection that says nothing.
FileDescriptor connected_to(int port) {
  FileDescriptor socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(static_cast<std::uint16_t>(port));
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(::connect(socket.get(), reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
  return socket;
}

TEST(HostileClientTest, AWrongTokenIsRefusedWithAReason) {
  const TemporaryFolder folder;
  Params params;
  params.token_file = token_file(folder);
  Served sut(params);
  ClientFacts facts = sut.facts();
  EXPECT_EQ(sut.client(facts)->status(), 401);
  facts.target = "/?token=0123456789abcdeg";
  EXPECT_EQ(sut.client(facts)->status(), 401);
  facts.target = std::string("/?token=") + secret;
  EXPECT_TRUE(sut.client(facts)->is_open());
  facts.target = "/";
  facts.headers["Authorization"] = std::string("Bearer ") + secret;
  EXPECT_TRUE(sut.client(facts)->is_open());
}

TEST(HostileClientTest, AFrameThatIsTooLongEndsTheConnectionAndNoOther) {
  Params params;
  params.frame_mib = 0.01;
  Served sut(params);
  const auto other = sut.client();
  const auto client = sut.client();
  client->say_text(std::string(20'000, ' '));
  EXPECT_TRUE(sut.until([&] { return client->ended().has_value(); }));
  sut.settle(*other);
  EXPECT_TRUE(other->is_open());
}

TEST(HostileClientTest, MoreConnectionsThanMayBeAreToldSo) {
  Params params;
  params.most_connections = 2;
  Served sut(params);
  const auto first = sut.client();
  auto second = sut.client();
  // More than are turned away at once: the others wait for their turn.
  std::vector<FileDescriptor> silent;
  for (int i = 0; i < 100; ++i) silent.push_back(connected_to(sut.facts().port));
  const HttpAnswer answer = fetch(sut.facts());
  EXPECT_EQ(answer.status, 503);
  EXPECT_THAT(answer.body, HasSubstr("more than 2 connections"));
  EXPECT_EQ(sut.client()->status(), 503);
  EXPECT_TRUE(first->is_open() && second->is_open());
  second.reset();
  EXPECT_TRUE(sut.until([&] { return sut.client()->is_open(); }));
}

TEST(HostileClientTest, WhoReadsNothingHoldsUpNobodyAndMissesTheOldest) {
  Params params;
  params.ping_s = 600;
  Served sut(params);
  ClientFacts facts = sut.facts();
  facts.reads = false;
  const auto reader = sut.client();
  SocketClient deaf(facts);
  ASSERT_TRUE(sut.until([&] { return deaf.is_open(); }));
  sut.subscribe(*reader, "/camera/image_raw/compressed", 1);
  const auto channel = reader->channel("/camera/image_raw/compressed");
  deaf.say({{"op", "subscribe"}, {"subscriptions", {{{"id", 1}, {"channelId", *channel}}}}});
  sut.settle(*reader);
  sensor_msgs::msg::CompressedImage picture;
  picture.data(std::vector<std::uint8_t>(100'000));
  for (std::size_t i = 1; i <= 100; ++i) {
    sut.bus.publish<topic::CameraImage>(picture);
    ASSERT_TRUE(sut.until([&] { return reader->frames(1).size() == i; })) << i;
  }
  sut.bus.run_for(std::chrono::seconds(2));  // until it has counted
  EXPECT_GT(sut.sut->drops(), 50U);
  EXPECT_FALSE(reader->was_told("too slow"));
}

TEST(HostileClientTest, WhoDoesNotAnswerAPingIsClosed) {
  Params params;
  params.ping_s = 0.1;
  Served sut(params);
  ClientFacts facts = sut.facts();
  facts.reads = false;  // so that it does not see the ping
  const auto alive = sut.client();
  const SocketClient deaf(facts);
  ASSERT_TRUE(sut.until([&] { return sut.sut->clients() == 2; }));
  EXPECT_TRUE(sut.until([&] { return sut.sut->clients() == 1; }));
  EXPECT_TRUE(alive->is_open());
}

TEST(HostileClientTest, MalformedFramesAreAnsweredOneByOne) {
  Served sut;
  const auto client = sut.client();
  constexpr std::size_t many = 200;
  for (std::size_t i = 0; i < many; ++i) {
    if (i % 2 == 0) {
      client->say_text("{\"op\": " + std::to_string(i));
    } else {
      client->say_bytes(std::string(i % 13, '\x05'));
    }
  }
  EXPECT_TRUE(sut.until([&] { return client->heard("status").size() == many; }));
  EXPECT_TRUE(client->is_open());
}

TEST(ServerStartTest, BeyondLoopbackItRefusesToStartWithoutTokenAndTls) {
  SimBus bus;
  Context context(bus, "operator_server", Role::gcs);
  Params params;
  params.address = "0.0.0.0";
  const auto error_of = [&] {
    try {
      const OperatorServerComponent sut(context, params);
    } catch (const ConfigError& error) {
      return std::string(error.what());
    }
    return std::string("none");
  };
  EXPECT_THAT(error_of(), HasSubstr("operator_server.address: 0.0.0.0 is heard beyond"));
  params.token_file = "/no/such/file";
  EXPECT_THAT(error_of(), HasSubstr("/no/such/file"));
  const TemporaryFolder folder;
  params.token_file = token_file(folder);
  params.certificate = "/no/such/certificate";
  EXPECT_THAT(error_of(), HasSubstr("belong together"));
  params.key = "/no/such/key";
  EXPECT_THAT(error_of(), HasSubstr("/no/such/certificate"));
}

TEST(ServerStartTest, APortThatIsTakenIsTriedAgainAndAllElseGoesOn) {
  auto first = std::make_unique<Served>();
  Params params;
  params.port = first->sut->port();
  SimBus bus;
  Context context(bus, "operator_server", Role::gcs);
  ::testing::internal::CaptureStderr();
  OperatorServerComponent sut(context, params);
  bus.add(sut);
  bus.run_for(std::chrono::seconds(20));
  EXPECT_EQ(sut.port(), 0);
  const std::string log = ::testing::internal::GetCapturedStderr();
  EXPECT_THAT(log, HasSubstr("cannot listen at 127.0.0.1:" + std::to_string(params.port)));
  EXPECT_EQ(log.find("cannot listen"), log.rfind("cannot listen"));
  first.reset();
  bus.run_for(std::chrono::seconds(5));
  EXPECT_EQ(sut.port(), params.port);
}

}  // namespace
}  // namespace tocsin
