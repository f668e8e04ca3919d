// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "graph.hpp"

namespace tocsin::check {

inline Port writes(const std::string& topic, Scope scope = Scope::host,
                   const std::string& qos = "sensor", const std::string& type = "Type") {
  return {topic, type, qos, scope, true};
}

inline Port reads(const std::string& topic, Scope scope = Scope::host,
                  const std::string& qos = "sensor", const std::string& type = "Type") {
  return {topic, type, qos, scope, false};
}

/// A reader that does without a writer.
inline Port may_read(const std::string& topic, Scope scope = Scope::host) {
  return {topic, "Type", "sensor", scope, false, Requests::profile, Writers::optional};
}

inline Node vehicle(const std::string& name, std::vector<Port> ports) {
  return {"uxv", Role::uxv, "drive", name, std::move(ports)};
}

inline Node station(const std::string& name, std::vector<Port> ports) {
  return {"gcs", Role::gcs, "desk", name, std::move(ports)};
}

}  // namespace tocsin::check
