// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

namespace tocsin {

/// A flow's topic in both worlds: `rt/ns/location` on the wire, `location` for people.
class TopicNames {
 public:
  explicit TopicNames(const std::string& ros_namespace)
      : prefix_(ros_namespace.empty() ? "rt/" : "rt/" + ros_namespace + "/") {}
  [[nodiscard]] std::string on_wire(const std::string& topic) const { return prefix_ + topic; }
  /// Nothing when the name is of another namespace, or of no topic.
  [[nodiscard]] std::optional<std::string> of_people(const std::string& on_wire) const {
    const bool ours = on_wire.compare(0, prefix_.size(), prefix_) == 0;
    return ours ? std::optional(on_wire.substr(prefix_.size())) : std::nullopt;
  }

 private:
  std::string prefix_;
};

/// On the link no topic is in a namespace: both sides of it may have one of their own.
[[nodiscard]] inline TopicNames link_names() { return TopicNames(""); }

}  // namespace tocsin
