// SPDX-License-Identifier: Apache-2.0
// With a real broker, mosquitto, and what becomes of it.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <chrono>
#include <csignal>
#include <functional>
#include <optional>
#include <thread>

#include "foundation/child_process.hpp"
#include "foundation/error.hpp"
#include "foundation/file_descriptor.hpp"
#include "foundation/temporary_folder.hpp"
#include "vda5050_gateway/broker.hpp"

namespace tocsin::vda5050 {
namespace {

using ::testing::HasSubstr;

/// A port of the loopback that nobody listens on now.
std::uint16_t free_port() {
  const FileDescriptor socket(::socket(AF_INET, SOCK_STREAM, 0));
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  if (::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), size) != 0 ||
      ::getsockname(socket.get(), reinterpret_cast<sockaddr*>(&address), &size) != 0) {
    throw EnvironmentError("no port is free");
  }
  return ntohs(address.sin_port);
}

class MqttBrokerTest : public ::testing::Test {
 protected:
  MqttBrokerTest() {
    address_.port = free_port();
    address_.client_id = "test";
  }
  ~MqttBrokerTest() override { end_server(SIGTERM); }
  void start_server(const std::string& more = "allow_anonymous true\n") {
    const std::string file = folder_.write(
        "mosquitto.conf", "listener " + std::to_string(address_.port) + " 127.0.0.1\n" +
                              (::getuid() == 0 ? "user root\n" : "") + more);
    server_ =
        start_child({{"/usr/sbin/mosquitto", "-c", file}, ChildSetup::Streams::piped, SIGKILL});
  }
  void end_server(int signal) {
    if (!server_) return;
    ::kill(server_->pid, signal);
    static_cast<void>(wait_for_child(server_->pid));
    server_.reset();
  }
  [[nodiscard]] std::unique_ptr<Broker> connect() const {
    return connect_mqtt(address_, {"v/connection", "gone", true, 1}, {"v/order"});
  }
  static bool eventually(const std::function<bool()>& holds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (!holds()) {
      if (std::chrono::steady_clock::now() > end) return false;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return true;
  }
  /// Publishes until it comes back: a subscription may be younger than the connection.
  static bool hears_itself(Broker& broker, const std::string& text) {
    return eventually([&] {
      static_cast<void>(broker.publish({"v/order", text}));
      while (const auto message = broker.take()) {
        if (message->topic == "v/order" && message->payload == text) return true;
      }
      return false;
    });
  }
  const TemporaryFolder folder_;
  BrokerAddress address_;
  std::optional<Child> server_;
};

TEST_F(MqttBrokerTest, ConnectsToABrokerThatComesLater) {
  const auto sut = connect();
  EXPECT_TRUE(eventually([&] { return !sut->trouble().empty(); }));
  EXPECT_FALSE(sut->is_connected());
  EXPECT_FALSE(sut->publish({"v/order", "lost"}));
  start_server();
  ASSERT_TRUE(eventually([&] { return sut->is_connected(); })) << sut->trouble();
  EXPECT_EQ(sut->trouble(), "");
  EXPECT_TRUE(hears_itself(*sut, "hello"));
}

TEST_F(MqttBrokerTest, ABrokerThatWasKilledIsConnectedToAgain) {
  start_server();
  const auto sut = connect();
  ASSERT_TRUE(eventually([&] { return sut->is_connected(); }));
  end_server(SIGKILL);
  ASSERT_TRUE(eventually([&] { return !sut->is_connected(); }));
  EXPECT_FALSE(sut->trouble().empty());
  start_server();
  ASSERT_TRUE(eventually([&] { return sut->connections() == 2; }));
  EXPECT_TRUE(hears_itself(*sut, "again")) << "it subscribes anew";
}

TEST_F(MqttBrokerTest, ABrokerThatIsToldNoPasswordSaysWhy) {
  folder_.write("users", "");
  start_server("allow_anonymous false\npassword_file " + folder_.path("users") + "\n");
  const auto sut = connect();
  const auto is_refused = [&] {
    return sut->trouble().find("not authorised") != std::string::npos;
  };
  EXPECT_TRUE(eventually(is_refused)) << sut->trouble();
  EXPECT_FALSE(sut->is_connected());
}

TEST_F(MqttBrokerTest, ALargeMessageIsCutWhereItsReaderSeesIt) {
  start_server();
  const auto sut = connect();
  ASSERT_TRUE(eventually([&] { return sut->is_connected(); }));
  ASSERT_TRUE(hears_itself(*sut, "ready"));
  static_cast<void>(sut->publish({"v/order", std::string(3 * most_message_bytes, 'x')}));
  ASSERT_TRUE(eventually([&] {
    const auto message = sut->take();
    return message && message->payload.size() == most_message_bytes + 1;
  }));
}

TEST_F(MqttBrokerTest, FilesThatCannotBeReadAreNamed) {
  const auto error_of = [this] {
    try {
      static_cast<void>(connect());
    } catch (const ConfigError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  address_.user = "site";
  address_.password_file = "/nowhere/password";
  EXPECT_THAT(error_of(), HasSubstr("password_file: cannot read /nowhere/password"));
  address_.password_file = "";
  address_.ca_file = "/nowhere/ca.pem";
  EXPECT_THAT(error_of(), HasSubstr("ca_file"));
}

}  // namespace
}  // namespace tocsin::vda5050
