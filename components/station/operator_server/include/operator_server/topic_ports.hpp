// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "operator_server/host_picture.hpp"
#include "operator_server/hub.hpp"
#include "runtime/port.hpp"

namespace tocsin::foxglove {

/// The topics that clients read and write, as ports of the component: one for each topic, however
/// many clients there are, and none for what nobody asks for.
class TopicPorts {
 public:
  explicit TopicPorts(Component& owner) : owner_(owner) {}

  void set_topics(const std::vector<SeenTopic>& topics);
  /// Reads these from now on, and no others. What cannot be read is named in `faults`.
  void read(const std::set<std::string>& topics, std::vector<std::string>& faults);
  /// Hands what came to the hub.
  void take(Hub& hub);

  /// Why the channel cannot be written; empty: it can, from now on.
  [[nodiscard]] std::string open(const ClientChannel& channel);
  struct Written {
    std::string fault;                       ///< why nothing was written; empty: it was
    std::optional<std::string> by_operator;  ///< of a message that names its operator: who
  };
  [[nodiscard]] Written write(const WriteMessage& message);
  /// Ends the writing of all other topics.
  void keep(const std::set<std::string>& written);

 private:
  struct Reading {
    const TypeInfo* type;
    std::unique_ptr<InputPort> input;
  };
  struct Writing {
    const TypeInfo* type;
    std::unique_ptr<Publication> publication;
  };
  [[nodiscard]] std::string open_new(const ClientChannel& channel, const TypeInfo& type);

  Component& owner_;
  std::map<std::string, SeenTopic> topics_;
  std::map<std::string, Reading> readings_;
  std::map<std::string, Writing> writings_;
};

}  // namespace tocsin::foxglove
