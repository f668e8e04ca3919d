// SPDX-License-Identifier: Apache-2.0
#include "section.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/names.hpp"
#include "foundation/printable.hpp"
#include "foundation/spelling.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin::deployment {
namespace {

bool is_relative_path(const std::string& text) {
  return text.rfind("./", 0) == 0 || text.rfind("../", 0) == 0;
}

/// "${a}, ${b}".
std::string listed(const std::vector<std::string>& names) {
  std::vector<std::string> written;
  for (const std::string& name : names) written.push_back("${" + name + "}");
  return joined(written);
}

/// `text` of `node` with every ${name} replaced.
std::string replaced(const std::string& text, const YAML::Node& node, const YamlSources& sources,
                     const Variables& variables) {
  std::string result;
  std::size_t from = 0;
  for (std::size_t at = text.find("${"); at != std::string::npos; at = text.find("${", from)) {
    const std::size_t end = text.find('}', at);
    const std::string name = text.substr(at + 2, end == std::string::npos ? end : end - at - 2);
    const auto found = variables.find(name);
    if (end == std::string::npos || found == variables.end()) {
      std::vector<std::string> known;
      for (const auto& variable : variables) known.push_back(variable.first);
      throw ConfigError("'" + printable(text) + "': unknown variable '" + printable(name) +
                        "'; allowed: " + listed(known) + suggestion(known, name) +
                        yaml_place(sources, node));
    }
    result += text.substr(from, at - from) + found->second;
    from = end + 1;
  }
  return result + text.substr(from);
}

}  // namespace

void expand(const YAML::Node& node, const YamlSources& sources, const Variables& variables,
            RelativePaths paths) {
  if (!node.IsDefined()) return;
  if (node.IsScalar()) {
    std::string text = replaced(node.Scalar(), node, sources, variables);
    if (paths == RelativePaths::of_the_file && is_relative_path(text))
      text = sources.path(node, text);
    YAML::Node same = node;
    if (text != node.Scalar()) same = text;  // in place, so that it keeps its line
  }
  for (const auto& entry : node)
    expand(node.IsMap() ? entry.second : entry, sources, variables, paths);
}

Section::Section(const YAML::Node& node, std::string owner, const YamlSources& sources)
    : node_(node), owner_(std::move(owner)), sources_(sources) {
  if (!node_.IsMap()) {
    throw ConfigError(owner_ + ": must be a map" + yaml_place(sources_, node_));
  }
}

Section::Section(const YAML::Node& node, std::string owner, const YamlSources& sources,
                 const std::vector<std::string>& allowed)
    : Section(node, std::move(owner), sources) {
  for (const auto& entry : node_) {
    const std::string key = entry.first.Scalar();
    if (std::find(allowed.begin(), allowed.end(), key) != allowed.end()) continue;
    throw ConfigError(owner_ + "." + printable(key) + ": unknown key; allowed: [" +
                      joined(allowed) + "]" + suggestion(allowed, key) +
                      yaml_place(sources_, entry.first));
  }
}

void Section::fail(const std::string& key, const std::string& what) const {
  const YAML::Node found = node_[key];
  throw ConfigError(owner_ + "." + key + ": " + what +
                    yaml_place(sources_, found.IsDefined() ? found : node_));
}

YAML::Node Section::find(const std::string& key) const { return node_[key]; }

std::string Section::text(const std::string& key, const std::string& fallback) const {
  const YAML::Node found = find(key);
  if (!found.IsDefined()) return fallback;
  if (!found.IsScalar()) fail(key, "is not a text");
  return found.Scalar();
}

std::string Section::required_text(const std::string& key) const {
  std::string value = text(key, "");
  if (value.empty()) fail(key, "is missing or empty");
  return value;
}

std::string Section::required_name(const std::string& key) const {
  std::string value = required_text(key);
  check_name(value, owner_ + "." + key, find(key), sources_);
  return value;
}

std::string Section::file(const std::string& key, Named named) const {
  const std::string value = text(key, "");
  if (value.empty()) return value;
  std::string path = sources_.path(find(key), value);
  const bool must_be_there = named == Named::must_be_readable;
  if (must_be_there && !std::ifstream(path)) fail(key, "'" + printable(path) + "' cannot be read");
  return path;
}

std::string Section::folder(const std::string& key, Named named) const {
  const std::string value = text(key, "");
  if (value.empty()) return value;
  std::string path = sources_.path(find(key), value);
  const bool must_be_there = named == Named::must_be_readable;
  if (must_be_there && !std::filesystem::is_directory(path)) {
    fail(key, "'" + printable(path) + "' is no folder");
  }
  return path;
}

int Section::whole(const std::string& key, int fallback, int min, int max) const {
  const std::string value = text(key, std::to_string(fallback));
  int read = 0;
  if (!YAML::convert<int>::decode(YAML::Node(value), read)) {
    fail(key, "'" + printable(value) + "' is not a whole number");
  }
  if (read < min || read > max) {
    fail(key, value + " is outside [" + std::to_string(min) + ", " + std::to_string(max) + "]");
  }
  return read;
}

bool Section::flag(const std::string& key, bool fallback) const {
  const std::string value = text(key, fallback ? "true" : "false");
  bool read = false;
  if (!YAML::convert<bool>::decode(YAML::Node(value), read)) {
    fail(key, "'" + printable(value) + "' is neither true nor false");
  }
  return read;
}

std::vector<std::string> Section::texts(const std::string& key) const {
  std::vector<std::string> values;
  for (const YAML::Node& item : items(key)) {
    if (!item.IsScalar()) fail(key, "has an element that is not a text");
    values.push_back(item.Scalar());
  }
  return values;
}

std::vector<YAML::Node> Section::items(const std::string& key) const {
  const YAML::Node found = find(key);
  if (!found.IsDefined()) return {};
  if (!found.IsSequence()) fail(key, "is not a list");
  std::vector<YAML::Node> nodes;
  for (const YAML::Node& item : found) nodes.push_back(item);
  return nodes;
}

void check_name(const std::string& name, const std::string& what, const YAML::Node& node,
                const YamlSources& sources) {
  if (is_name(name)) return;
  throw ConfigError(what + ": '" + printable(name) + "' is not a name (" + name_rule + ")" +
                    yaml_place(sources, node));
}

}  // namespace tocsin::deployment
