// SPDX-License-Identifier: Apache-2.0
#include "deployment/traffic_file.hpp"

#include <yaml-cpp/yaml.h>

#include <set>

#include "foundation/yaml_extends.hpp"

namespace tocsin::deployment {
namespace {

/// `topics` of a class come after those that the base has there.
ListMerge traffic_lists(const YamlPath& path) {
  return path.size() == 3 && path[2] == "topics" ? ListMerge::append : ListMerge::replace;
}

/// The topics that the classes of a role name.
std::set<std::string> topics_of(const YAML::Node& classes) {
  std::set<std::string> topics;
  if (!classes.IsDefined() || !classes.IsMap()) return topics;
  for (const auto& entry : classes) {
    if (!entry.second.IsMap()) continue;
    for (const YAML::Node& topic : entry.second["topics"]) {
      if (topic.IsScalar()) topics.insert(topic.Scalar());
    }
  }
  return topics;
}

/// The list without `topics`.
YAML::Node without(const YAML::Node& list, const std::set<std::string>& topics) {
  YAML::Node kept(YAML::NodeType::Sequence);
  for (const YAML::Node& topic : list) {
    if (!topic.IsScalar() || topics.count(topic.Scalar()) == 0) kept.push_back(topic);
  }
  return kept;
}

/// A map of the same keys with other values; what is no map stays as it is.
template <class Change>
YAML::Node changed(const YAML::Node& map, Change change) {
  if (!map.IsMap()) return map;
  YAML::Node copy(YAML::NodeType::Map);
  for (const auto& entry : map)
    copy.force_insert(entry.first, change(entry.first.Scalar(), entry.second));
  return copy;
}

/// The base without the topics that `own` names: a topic is in the class that was said last.
YAML::Node without_moved(const YAML::Node& base, const YAML::Node& own) {
  if (!own.IsMap()) return base;
  return changed(base, [&](const std::string& role, const YAML::Node& classes) {
    const auto moved = topics_of(own[role]);
    return changed(classes, [&](const std::string&, const YAML::Node& one) {
      return changed(one, [&](const std::string& key, const YAML::Node& value) {
        return key == "topics" && value.IsSequence() ? without(value, moved) : value;
      });
    });
  });
}

}  // namespace

YAML::Node read_traffic_file(const std::string& path, const std::string& share,
                             YamlSources& sources) {
  return read_extended(path, {share + "/config", traffic_lists, without_moved}, sources);
}

}  // namespace tocsin::deployment
