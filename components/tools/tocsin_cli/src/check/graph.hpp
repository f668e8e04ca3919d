// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "foundation/role.hpp"
#include "idl_support/topic_info.hpp"
#include "runtime/bus.hpp"

namespace tocsin::check {

/// One end of a topic that a component has made.
struct Port {
  std::string topic;
  std::string type;  ///< name on the wire
  std::string qos;   ///< profile
  Scope scope = Scope::host;
  bool writes = false;
  Requests requests = Requests::profile;  ///< of a reader
  Writers writers = Writers::needed;      ///< of a reader
};

/// One component of a deployment with its ports.
struct Node {
  std::string host;
  Role role = Role::uxv;
  std::string container;
  std::string name;
  std::vector<Port> ports;

  [[nodiscard]] std::string path() const { return host + "/" + container + "/" + name; }
};

/// Every component of a deployment.
using Graph = std::vector<Node>;

enum class Severity { note, warning, error };

/// One thing that the check has to say.
struct Finding {
  Severity severity;
  std::string text;
};

}  // namespace tocsin::check
