// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "deployment/deployment.hpp"
#include "foundation/file_descriptor.hpp"

namespace tocsin::cli {

/// A port that a process serves to this computer though its host has a network of its own.
struct ServedPort {
  std::string process;  ///< "host/process"
  std::string url;      ///< `http://127.0.0.1:8765/`
  int port = 0;
  FileDescriptor socket = {};  ///< that listens on this computer's loopback; none: see `fault`
  std::string fault = {};
};

/// The ports of all components operator_server of a deployment with an emulated radio, whose `port`
/// the deployment says: the launcher listens for them outside of the emulated network, and hands
/// the sockets over. Only on loopback.
[[nodiscard]] std::vector<ServedPort> served_ports(const deployment::Deployment& deployment);

/// Listens for each; those that cannot have a fault afterwards.
void listen_for(std::vector<ServedPort>& ports);

}  // namespace tocsin::cli
