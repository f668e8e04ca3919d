// SPDX-License-Identifier: Apache-2.0
#include "served_port.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <yaml-cpp/yaml.h>

#include <cerrno>
#include <cstdlib>
#include <optional>
#include <system_error>

namespace tocsin::cli {
namespace {

constexpr const char* serving_component = "operator_server";
constexpr const char* loopback = "127.0.0.1";

/// Text of a parameter that the deployment says; else empty.
std::string said(const deployment::ComponentInstance& component, const char* key) {
  const YAML::Node value = (*component.parameters)[key];
  return value.IsDefined() && value.IsScalar() ? value.Scalar() : std::string();
}

/// The port that a component serves on loopback; nothing when it does not, or does not say which.
std::optional<int> port_of(const deployment::ComponentInstance& component) {
  const std::string address = said(component, "address");
  const int port = std::atoi(said(component, "port").c_str());
  const bool serves = component.component == serving_component && port > 0;
  return serves && (address.empty() || address == loopback) ? std::optional<int>(port)
                                                            : std::nullopt;
}

}  // namespace

std::vector<ServedPort> served_ports(const deployment::Deployment& deployment) {
  std::vector<ServedPort> ports;
  if (!deployment.radio) return ports;
  for (const deployment::Host& host : deployment.hosts) {
    for (const deployment::Container& container : host.containers) {
      for (const deployment::ComponentInstance& one : container.components) {
        const auto port = port_of(one);
        if (!port) continue;
        const std::string scheme = said(one, "certificate").empty() ? "http://" : "https://";
        ports.push_back({host.name + "/" + container.name,
                         scheme + loopback + ":" + std::to_string(*port) + "/", *port});
      }
    }
  }
  return ports;
}

void listen_for(std::vector<ServedPort>& ports) {
  for (ServedPort& one : ports) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(one.port));
    ::inet_pton(AF_INET, loopback, &address.sin_addr);
    FileDescriptor socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
    const int on = 1;  // connections of an earlier run do not hold it up
    if (socket && ::setsockopt(socket.get(), SOL_SOCKET, SO_REUSEADDR, &on, sizeof on) == 0 &&
        ::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
        ::listen(socket.get(), SOMAXCONN) == 0) {
      one.socket = std::move(socket);
    } else {
      one.fault = std::system_category().message(errno);
    }
  }
}

}  // namespace tocsin::cli
