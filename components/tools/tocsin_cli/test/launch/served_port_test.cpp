// SPDX-License-Identifier: Apache-2.0
#include "served_port.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <yaml-cpp/yaml.h>

namespace tocsin::cli {
namespace {

deployment::Deployment with_server(const std::string& parameters, const std::string& component) {
  deployment::Deployment made;
  made.radio = deployment::Radio{"c.yaml", "w.yaml"};
  deployment::Host host;
  host.name = "gcs";
  const auto node = std::make_shared<const YAML::Node>(YAML::Load(parameters));
  deployment::Container container;
  container.name = "page";
  container.components.push_back({component, component, node});
  host.containers.push_back(container);
  made.hosts.push_back(host);
  return made;
}

TEST(ServedPortTest, IsOneThatTheDeploymentSays) {
  const auto ports = served_ports(with_server("{port: 8765}", "operator_server"));
  ASSERT_EQ(ports.size(), 1U);
  EXPECT_EQ(ports[0].process, "gcs/page");
  EXPECT_EQ(ports[0].url, "http://127.0.0.1:8765/");
  const auto secured =
      served_ports(with_server("{port: 1, certificate: x, address: 127.0.0.1}", "operator_server"));
  EXPECT_EQ(secured.at(0).url, "https://127.0.0.1:1/");
}

TEST(ServedPortTest, IsNoneOfOthersBeyondLoopbackOrWithoutAnEmulatedRadio) {
  EXPECT_TRUE(served_ports(with_server("{port: 8765}", "camera")).empty());
  EXPECT_TRUE(served_ports(with_server("{}", "operator_server")).empty());
  EXPECT_TRUE(
      served_ports(with_server("{port: 8765, address: 0.0.0.0}", "operator_server")).empty());
  auto real = with_server("{port: 8765}", "operator_server");
  real.radio.reset();
  EXPECT_TRUE(served_ports(real).empty());
}

TEST(ServedPortTest, APortThatIsTakenIsAFaultOfThatPort) {
  std::vector<ServedPort> first(1);
  first[0].port = 0;  // a free one
  listen_for(first);
  ASSERT_TRUE(first[0].socket);
  sockaddr_in address{};
  socklen_t size = sizeof address;
  ::getsockname(first[0].socket.get(), reinterpret_cast<sockaddr*>(&address), &size);
  std::vector<ServedPort> second(2);
  second[0].port = ntohs(address.sin_port);
  listen_for(second);
  EXPECT_FALSE(second[0].socket);
  EXPECT_EQ(second[0].fault, "Address already in use");
  EXPECT_TRUE(second[1].socket);
}

}  // namespace
}  // namespace tocsin::cli
