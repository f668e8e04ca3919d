// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tocsin {

/// How far a topic reaches.
enum class Scope {
  host,  ///< Stays on its host: loopback, never the radio.
  link,  ///< Also crosses the radio link, through the gate.
};

/// What both ends of a topic must agree on, besides the type.
struct TopicInfo {
  const char* name;  ///< ROS name without leading slash: `odom` becomes `rt/odom` on the wire.
  const char* qos;   ///< A profile of config/qos.yaml.
  Scope scope;
};

}  // namespace tocsin
