// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tocsin {

/// How far a topic reaches.
enum class Scope {
  host,  ///< Stays on its host: loopback, never the radio.
  link,  ///< Also crosses the radio link, through the gate.
};

/// What readers ask of the writers that they are matched with.
enum class Requests {
  profile,   ///< What the topic's profile says, as writers offer it.
  anything,  ///< Nothing: best effort, volatile. Every writer is heard; a late reader waits for the
             ///< next sample.
};

/// What both ends of a topic must agree on, besides the type.
struct TopicInfo {
  const char* name;  ///< ROS name without leading slash: `odom` becomes `rt/odom` on the wire.
  const char* qos;   ///< A profile of config/qos.yaml.
  Scope scope;
  Requests requests = Requests::profile;
};

/// Topics of a list, for those who handle all of them alike.
namespace topic {
template <class... Topics>
struct List {};
}  // namespace topic

}  // namespace tocsin
