// SPDX-License-Identifier: Apache-2.0
#include "idl_support/topic_registry.hpp"

#include <algorithm>
#include <mutex>
#include <set>

namespace tocsin {
namespace {

struct TopicRegistry {
  std::mutex mutex;
  std::vector<KnownTopic> topics;
  std::set<std::string> words;
};

/// A function-local object: it exists whichever library registers first.
TopicRegistry& topic_registry() {
  static TopicRegistry instance;
  return instance;
}

}  // namespace

void register_topic(const TopicInfo& info, const TypeInfo& type) {
  const std::lock_guard<std::mutex> lock(topic_registry().mutex);
  auto& topics = topic_registry().topics;
  const std::string name = info.name;
  const bool known = std::any_of(topics.begin(), topics.end(),
                                 [&](const KnownTopic& topic) { return topic.info.name == name; });
  if (!known) topics.push_back({info, &type});
}

std::vector<KnownTopic> known_topics() {
  const std::lock_guard<std::mutex> lock(topic_registry().mutex);
  return topic_registry().topics;
}

TopicInfo make_topic_info(const std::string& name, const std::string& qos, Scope scope) {
  const std::lock_guard<std::mutex> lock(topic_registry().mutex);
  auto& words = topic_registry().words;
  return {words.insert(name).first->c_str(), words.insert(qos).first->c_str(), scope};
}

}  // namespace tocsin
