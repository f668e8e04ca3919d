// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "foundation/yaml_sources.hpp"

namespace tocsin {

/// What a list of an extending file does with the list of its base.
enum class ListMerge {
  replace,  ///< takes its place
  append,   ///< comes after it
  by_name,  ///< an entry of a known name is merged into that one, others come after it
};

/// Keys and names from the top of a file down to a list.
using YamlPath = std::vector<std::string>;

/// How files of one kind extend each other.
struct ExtendRules {
  std::string shipped;  ///< folder where a bare name is looked for when it is not beside the file
  ListMerge (*lists)(const YamlPath& path) = [](const YamlPath&) { return ListMerge::replace; };
  /// What stands for the base when `own` is merged into it; null: the base itself.
  YAML::Node (*prepare)(const YAML::Node& base, const YAML::Node& own) = nullptr;
};

/// What a file took away from its base.
struct YamlRemoval {
  YamlPath path;  ///< its last part is the key or name
  std::shared_ptr<const YAML::Node> value;
};

/// Reads a YAML file and the files that it `extends`, one name or a list of names whose later ones
/// win. What the file says is merged into them: maps key by key, lists by the rules, everything
/// else replaces. `key: ~` takes a key away, `- name: ~` an entry of a list by name; a removal of
/// what is not there is an error, as is an empty value in its place. Entries by name are a name, or
/// a map whose `name`, else `component`, is it.
///
/// A relative name is relative to its file. A bare one that is not there, or is that file itself,
/// is a shipped one. The key `extends` is not in the result. Nodes of all files are in `sources`.
/// What was taken away is added to `removed`, when given.
/// Throws ConfigError with file and line; for files that extend each other, with the chain of them.
[[nodiscard]] YAML::Node read_extended(const std::string& path, const ExtendRules& rules,
                                       YamlSources& sources,
                                       std::vector<YamlRemoval>* removed = nullptr);

}  // namespace tocsin
