// SPDX-License-Identifier: Apache-2.0
#include "deployment/traffic_file.hpp"

#include <yaml-cpp/yaml.h>

#include <map>
#include <set>

#include "foundation/yaml_extends.hpp"

namespace tocsin::deployment {
namespace {

/// What a class lists by name; each is in one class of a role.
const std::set<std::string> name_lists{"topics", "services", "actions"};

/// The names of a class come after those that the base has there.
ListMerge traffic_lists(const YamlPath& path) {
  return path.size() == 3 && name_lists.count(path[2]) != 0 ? ListMerge::append
                                                            : ListMerge::replace;
}

/// The names that the classes of a role have, by list.
std::map<std::string, std::set<std::string>> names_of(const YAML::Node& classes) {
  std::map<std::string, std::set<std::string>> names;
  if (!classes.IsDefined() || !classes.IsMap()) return names;
  for (const auto& entry : classes) {
    if (!entry.second.IsMap()) continue;
    for (const std::string& list : name_lists) {
      for (const YAML::Node& name : entry.second[list]) {
        if (name.IsScalar()) names[list].insert(name.Scalar());
      }
    }
  }
  return names;
}

/// The list without `names`.
YAML::Node without(const YAML::Node& list, const std::set<std::string>& names) {
  YAML::Node kept(YAML::NodeType::Sequence);
  for (const YAML::Node& name : list) {
    if (!name.IsScalar() || names.count(name.Scalar()) == 0) kept.push_back(name);
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

/// The base without what `own` names: a name is in the class that was said last.
YAML::Node without_moved(const YAML::Node& base, const YAML::Node& own) {
  if (!own.IsMap()) return base;
  return changed(base, [&](const std::string& role, const YAML::Node& classes) {
    auto moved = names_of(own[role]);
    return changed(classes, [&](const std::string&, const YAML::Node& one) {
      return changed(one, [&](const std::string& key, const YAML::Node& value) {
        return name_lists.count(key) != 0 && value.IsSequence() ? without(value, moved[key])
                                                                : value;
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
