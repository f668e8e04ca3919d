// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>

#include "component/log_lines.hpp"
#include "ros_idl/rcl_interfaces.hpp"
#include "runtime/component.hpp"

namespace tocsin {

/// Where ROS 2 reads the log of all nodes, whatever their namespace.
struct RosoutTopic {
  using Message = rcl_interfaces::msg::Log;
  static constexpr TopicInfo info{"/rosout", "log", Scope::host};
};

/// The logger of a node in ROS 2's words: `uxv.navigator`, or `navigator` without namespace.
[[nodiscard]] std::string logger_name(const std::string& ros_namespace, const std::string& node);
/// The node that a logger in these words is of; empty for the namespace itself, and for all.
[[nodiscard]] std::string node_of_logger(const std::string& ros_namespace,
                                         const std::string& logger);

/// Tells /rosout what the nodes of this process log. One thread, that of its owner, which is ticked
/// when there is a line; who logs waits for nothing.
class Rosout {
 public:
  explicit Rosout(Component& owner);
  /// Each of these nodes has the topic from now on, others have not.
  void serve(const std::set<std::string>& nodes);
  /// Writes what has come. A line of somebody who is no such node goes by the owner's end.
  void tell();

 private:
  [[nodiscard]] std::unique_ptr<Publication> advertise(const std::string& node);
  Publication& end_of(const std::string& node);
  void write(const LogLine& line);
  Component& owner_;
  std::map<std::string, std::unique_ptr<Publication>> ends_;  ///< by node, its owner's among them
  LogLines lines_;  // last: nobody notices the owner when the rest is gone
};

}  // namespace tocsin
