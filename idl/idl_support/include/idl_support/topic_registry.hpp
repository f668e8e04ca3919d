// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "idl_support/topic_info.hpp"
#include "idl_support/type_info.hpp"

namespace tocsin {

/// A topic as a library of messages states it.
struct KnownTopic {
  TopicInfo info;
  const TypeInfo* type;
};

/// Makes a topic known to whoever handles topics by their names. The first of a name stands.
void register_topic(const TopicInfo& info, const TypeInfo& type);

/// Registers the topics of a list; for a library of messages, before main.
template <class... Topics>
bool register_topics(topic::List<Topics...>) {
  (register_topic(Topics::info, type_info<typename Topics::Message>()), ...);
  return true;
}

/// The topics of all loaded libraries, in the order of their registration. Any thread.
[[nodiscard]] std::vector<KnownTopic> known_topics();

/// The facts of a topic whose names are made at run time. The words stay for the life of the
/// process, as those of a constant do. Any thread.
[[nodiscard]] TopicInfo make_topic_info(const std::string& name, const std::string& qos,
                                        Scope scope);

}  // namespace tocsin
