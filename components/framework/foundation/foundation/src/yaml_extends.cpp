// SPDX-License-Identifier: Apache-2.0
#include "foundation/yaml_extends.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <list>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_files = 100;

/// A key with its value, or a name with its entry; a name alone has no key.
struct Item {
  std::string name;
  YAML::Node key;
  YAML::Node value;
};

/// Never assigned to, only put in and taken out: assigning a YAML::Node changes all that share it.
using Items = std::list<Item>;

std::string names_of(const Items& items) {
  return "[" + joined_of(items, [](const Item& item) { return item.name; }) + "]";
}

Items::iterator find(Items& items, const std::string& name) {
  return std::find_if(items.begin(), items.end(),
                      [&](const Item& item) { return item.name == name; });
}

Items items_of_map(const YAML::Node& map) {
  Items items;
  for (const auto& entry : map) items.push_back({entry.first.Scalar(), entry.first, entry.second});
  return items;
}

YAML::Node map_of(const Items& items) {
  YAML::Node map(YAML::NodeType::Map);
  for (const Item& item : items) map.force_insert(item.key, item.value);
  return map;
}

YAML::Node list_of(const Items& items) {
  YAML::Node list(YAML::NodeType::Sequence);
  for (const Item& item : items) list.push_back(item.value);
  return list;
}

/// Merges what one file says into what its base says.
class Merger {
 public:
  Merger(const ExtendRules& rules, const YamlSources& sources, std::vector<YamlRemoval>& removed)
      : rules_(rules), sources_(sources), removed_(removed) {}

  /// What `own` says of `base`: new maps and lists, of the nodes of both.
  [[nodiscard]] YAML::Node merge(const YAML::Node& base, const YAML::Node& own) {
    if (base.IsMap() && own.IsMap()) {
      return map_of(merge_items(items_of_map(base), items_of_map(own)));
    }
    if (!base.IsSequence() || !own.IsSequence()) return own;
    switch (rules_.lists(path_)) {
      case ListMerge::replace:
        return own;
      case ListMerge::append:
        return appended(base, own);
      case ListMerge::by_name:
        return list_of(merge_items(items_of_list(base), items_of_list(own)));
    }
    return own;
  }

 private:
  [[nodiscard]] static YAML::Node appended(const YAML::Node& base, const YAML::Node& own) {
    YAML::Node all(YAML::NodeType::Sequence);
    for (const YAML::Node& entry : base) all.push_back(entry);
    for (const YAML::Node& entry : own) all.push_back(entry);
    return all;
  }

  [[nodiscard]] Items merge_items(Items merged, const Items& own) {
    for (const Item& item : own) put(item, merged);
    return merged;
  }

  void put(const Item& item, Items& merged) {
    const auto known = find(merged, item.name);
    const bool is_known = known != merged.end();
    if (item.value.IsNull() && removes(item, is_known, merged)) {
      path_.push_back(item.name);
      removed_.push_back({path_, std::make_shared<const YAML::Node>(known->value)});
      path_.pop_back();
      merged.erase(known);
      return;
    }
    if (!is_known) {
      merged.push_back(item);
      return;
    }
    if (!item.key.IsDefined()) return;  // a name alone: the base says more
    path_.push_back(item.name);
    merged.insert(known, {item.name, item.key, merge(known->value, item.value)});
    path_.pop_back();
    merged.erase(known);
  }

  /// Whether `key: ~` takes something away; an empty value of an unknown key stays what it is.
  [[nodiscard]] bool removes(const Item& item, bool known, const Items& merged) const {
    const bool written = item.value.Mark().line == item.key.Mark().line;
    if (written && known) return true;
    if (!written && !known) return false;
    const std::string name = whole_name(item.name);
    throw ConfigError(name +
                      (written
                           ? ": there is nothing to remove; the base has " + names_of(merged)
                           : ": is empty; '" + item.name + ": ~' takes away what the base has") +
                      yaml_place(sources_, item.key));
  }

  [[nodiscard]] std::string whole_name(const std::string& last) const {
    std::string name;
    for (const std::string& part : path_) name += part + ".";
    return name + last;
  }

  [[nodiscard]] Items items_of_list(const YAML::Node& list) const {
    Items items;
    for (const YAML::Node& entry : list) items.push_back(item_of(entry));
    return items;
  }

  [[nodiscard]] Item item_of(const YAML::Node& entry) const {
    if (entry.IsScalar()) return {entry.Scalar(), YAML::Node(YAML::NodeType::Undefined), entry};
    if (entry.IsMap() && entry.size() == 1 && entry.begin()->second.IsNull()) {
      return {entry.begin()->first.Scalar(), entry.begin()->first, entry.begin()->second};
    }
    for (const char* key : {"name", "component"}) {
      const YAML::Node name = entry.IsMap() ? entry[key] : YAML::Node();
      if (name.IsDefined() && name.IsScalar()) return {name.Scalar(), name, entry};
    }
    throw ConfigError(whole_name("*") + ": an entry has no name" + yaml_place(sources_, entry));
  }

  const ExtendRules& rules_;
  const YamlSources& sources_;
  std::vector<YamlRemoval>& removed_;
  YamlPath path_;
};

/// Follows `extends` from file to file.
class Reader {
 public:
  Reader(const ExtendRules& rules, YamlSources& sources, std::vector<YamlRemoval>& removed)
      : rules_(rules), sources_(sources), removed_(removed) {}

  YAML::Node read(const std::string& path) {
    YAML::Node own = sources_.read(path);
    if (!own.IsMap() || !own["extends"]) return own;
    const std::vector<YAML::Node> bases = names_in(own["extends"]);
    own.remove("extends");
    chain_.push_back(path);
    YAML::Node whole = read(file_of(bases.front()));
    for (std::size_t i = 1; i < bases.size(); ++i)
      whole.reset(merge(whole, read(file_of(bases[i]))));
    chain_.pop_back();
    return merge(whole, own);
  }

 private:
  [[nodiscard]] YAML::Node merge(const YAML::Node& base, const YAML::Node& own) {
    const YAML::Node prepared = rules_.prepare != nullptr ? rules_.prepare(base, own) : base;
    return Merger(rules_, sources_, removed_).merge(prepared, own);
  }

  [[noreturn]] void fail(const YAML::Node& node, const std::string& what) const {
    throw ConfigError("extends: " + what + yaml_place(sources_, node));
  }

  [[nodiscard]] std::vector<YAML::Node> names_in(const YAML::Node& extends) const {
    std::vector<YAML::Node> names;
    if (extends.IsScalar()) names.push_back(extends);
    if (extends.IsSequence()) {
      for (const YAML::Node& name : extends) names.push_back(name);
    }
    const bool all_names = std::all_of(names.begin(), names.end(),
                                       [](const YAML::Node& name) { return name.IsScalar(); });
    if (names.empty() || !all_names) fail(extends, "must be a file or a list of files");
    return names;
  }

  /// The file that `name` means.
  [[nodiscard]] std::string file_of(const YAML::Node& name) {
    const std::string& text = name.Scalar();
    const std::string beside = sources_.path(name, text);
    const fs::path shipped = fs::path(rules_.shipped) / text;
    std::error_code absent;
    const bool bare = text.find('/') == std::string::npos;
    const bool itself = fs::equivalent(beside, sources_.file(name), absent);
    std::string found = beside;
    if (bare && (itself || !fs::exists(beside)) && fs::exists(shipped)) found = shipped.string();
    if (!fs::exists(found)) {
      fail(name, "no file " + beside + (bare ? ", nor is " + shipped.string() + " there" : ""));
    }
    refuse_circle(name, found);
    if (++followed_ >= most_files) {
      fail(name, "more than " + std::to_string(most_files) + " files");
    }
    return found;
  }

  void refuse_circle(const YAML::Node& name, const std::string& next) const {
    std::error_code absent;
    std::string told;
    bool circle = false;
    for (const std::string& file : chain_) {
      circle = circle || fs::equivalent(file, next, absent);
      if (circle) told += file + " extends ";
    }
    if (circle) fail(name, "goes in a circle: " + told + next);
  }

  const ExtendRules& rules_;
  YamlSources& sources_;
  std::vector<YamlRemoval>& removed_;
  std::vector<std::string> chain_;
  std::size_t followed_ = 0;  ///< of all files
};

}  // namespace

YAML::Node read_extended(const std::string& path, const ExtendRules& rules, YamlSources& sources,
                         std::vector<YamlRemoval>* removed) {
  std::vector<YamlRemoval> ignored;
  return Reader(rules, sources, removed != nullptr ? *removed : ignored).read(path);
}

}  // namespace tocsin
