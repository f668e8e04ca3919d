// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "example_idl/example_msgs.hpp"
#include "idl_support/topic_info.hpp"

namespace example {

/// What the talker says. Stays on its host.
struct Greetings {
  using Message = example_msgs::msg::Greeting;
  static constexpr tocsin::TopicInfo info{"greetings", "event", tocsin::Scope::host};
};

/// What the odometer reads. Crosses the radio link, so it needs a traffic class, and its
/// QoS profile is one of its own: see bringup/traffic.yaml and bringup/qos.yaml.
struct DistanceDriven {
  using Message = example_msgs::msg::Distance;
  static constexpr tocsin::TopicInfo info{"distance_driven", "reading", tocsin::Scope::link};
};

using AllTopics = tocsin::topic::List<Greetings, DistanceDriven>;

}  // namespace example
