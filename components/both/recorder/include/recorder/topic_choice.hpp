// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "idl_support/topic_registry.hpp"

namespace tocsin {

/// A topic that is to be recorded.
struct ChosenTopic {
  TopicInfo info;
  const TypeInfo* type;
  bool named = false;  ///< asked for by its own name, not by a rule for many
};

/// What a user wants recorded.
struct TopicWishes {
  bool link_topics = true;  ///< every known topic that crosses the link
  /// Besides, each one of: the name of a known topic; a pattern (`*`, `?`, `[...]`, as for files,
  /// `*` passes slashes) of known ones; `NAME TYPE [QOS [host|link]]` of any other, for example
  /// `scan sensor_msgs/msg/LaserScan`. A slash in front of a name is left out.
  std::vector<std::string> topics;
};

/// Whether each wish is a known topic or has a known type; of a pattern it cannot be told.
[[nodiscard]] bool are_stated(const std::vector<std::string>& wishes,
                              const std::vector<KnownTopic>& known);

/// The topics that are wished for, each once: those of the link first, then in the order of the
/// wishes. `owner` is the name in front of errors.
/// Throws ConfigError for an unknown name (with a suggestion), a pattern that nothing matches, a
/// type that no loaded library has, a name, type or scope that is none, a topic with another type.
[[nodiscard]] std::vector<ChosenTopic> choose_topics(const std::string& owner,
                                                     const TopicWishes& wishes,
                                                     const std::vector<KnownTopic>& known);

}  // namespace tocsin
