// SPDX-License-Identifier: Apache-2.0
#include "section.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "foundation/error.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin::deployment {
namespace {

bool is_name(const std::string& text) {
  const auto allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  };
  return !text.empty() && text[0] >= 'a' && text[0] <= 'z' &&
         std::all_of(text.begin(), text.end(), allowed);
}

bool is_relative_path(const std::string& text) {
  return text.rfind("./", 0) == 0 || text.rfind("../", 0) == 0;
}

}  // namespace

Source::Source(std::string file, std::map<std::string, std::string> variables)
    : file_(std::move(file)), variables_(std::move(variables)) {}

std::string Source::expand(const std::string& text, const YAML::Node& node) const {
  std::string result;
  std::size_t from = 0;
  for (std::size_t at = text.find("${"); at != std::string::npos; at = text.find("${", from)) {
    const std::size_t end = text.find('}', at);
    const std::string name = text.substr(at + 2, end == std::string::npos ? end : end - at - 2);
    const auto found = variables_.find(name);
    if (end == std::string::npos || found == variables_.end()) {
      throw ConfigError("'" + text + "': unknown variable '" + name +
                        "'; allowed: ${run_dir}, ${seed}, ${share}" + yaml_place(file_, node));
    }
    result += text.substr(from, at - from) + found->second;
    from = end + 1;
  }
  return result + text.substr(from);
}

std::string Source::path(const std::string& text) const {
  const std::filesystem::path folder = std::filesystem::absolute(file_).parent_path();
  return (folder / text).lexically_normal().string();
}

YAML::Node Source::resolve(const YAML::Node& node) const {
  YAML::Node copy(node.Type());
  if (node.IsScalar()) {
    const std::string text = expand(node.Scalar(), node);
    copy = is_relative_path(text) ? path(text) : text;
  }
  for (const auto& entry : node) {
    if (node.IsSequence()) copy.push_back(resolve(entry));
    if (node.IsMap()) copy[entry.first.Scalar()] = resolve(entry.second);
  }
  return copy;
}

std::string Source::place(const YAML::Node& node) const {
  return file_ + ":" + std::to_string(node.Mark().line + 1);
}

Section::Section(const YAML::Node& node, std::string owner, const Source& source)
    : node_(node), owner_(std::move(owner)), source_(source) {
  if (!node_.IsMap()) {
    throw ConfigError(owner_ + ": must be a map" + yaml_place(source_.file(), node_));
  }
  std::set<std::string> seen;
  for (const auto& entry : node_) {
    if (!seen.insert(entry.first.Scalar()).second) {
      throw ConfigError(owner_ + "." + entry.first.Scalar() + ": given twice" +
                        yaml_place(source_.file(), entry.first));
    }
  }
}

void Section::fail(const std::string& key, const std::string& what) const {
  const YAML::Node& map = node_;  // the const operator[] does not add the key
  const YAML::Node found = map[key];
  throw ConfigError(owner_ + "." + key + ": " + what +
                    yaml_place(source_.file(), found.IsDefined() ? found : node_));
}

YAML::Node Section::find(const std::string& key) {
  named_.push_back(key);
  const YAML::Node& map = node_;
  return map[key];
}

std::string Section::text(const std::string& key, const std::string& fallback) {
  const YAML::Node found = find(key);
  if (!found.IsDefined()) return fallback;
  if (!found.IsScalar()) fail(key, "is not a text");
  return source_.expand(found.Scalar(), found);
}

std::string Section::required_text(const std::string& key) {
  std::string value = text(key, "");
  if (value.empty()) fail(key, "is missing or empty");
  return value;
}

std::string Section::required_name(const std::string& key) {
  std::string value = required_text(key);
  check_name(value, owner_ + "." + key, find(key), source_);
  return value;
}

std::string Section::file(const std::string& key) {
  const std::string value = text(key, "");
  if (value.empty()) return value;
  std::string path = source_.path(value);
  if (!std::ifstream(path)) fail(key, "'" + path + "' cannot be read");
  return path;
}

int Section::whole(const std::string& key, int fallback, int min, int max) {
  const std::string value = text(key, std::to_string(fallback));
  int read = 0;
  if (!YAML::convert<int>::decode(YAML::Node(value), read)) {
    fail(key, "'" + value + "' is not a whole number");
  }
  if (read < min || read > max) {
    fail(key, value + " is outside [" + std::to_string(min) + ", " + std::to_string(max) + "]");
  }
  return read;
}

bool Section::flag(const std::string& key, bool fallback) {
  const std::string value = text(key, fallback ? "true" : "false");
  bool read = false;
  if (!YAML::convert<bool>::decode(YAML::Node(value), read)) {
    fail(key, "'" + value + "' is neither true nor false");
  }
  return read;
}

std::vector<std::string> Section::texts(const std::string& key) {
  std::vector<std::string> values;
  for (const YAML::Node& item : items(key)) {
    if (!item.IsScalar()) fail(key, "has an element that is not a text");
    values.push_back(source_.expand(item.Scalar(), item));
  }
  return values;
}

std::vector<YAML::Node> Section::items(const std::string& key) {
  const YAML::Node found = find(key);
  if (!found.IsDefined()) return {};
  if (!found.IsSequence()) fail(key, "is not a list");
  std::vector<YAML::Node> nodes;
  for (const YAML::Node& item : found) nodes.push_back(item);
  return nodes;
}

void Section::reject_unknown_keys() const {
  for (const auto& entry : node_) {
    const std::string key = entry.first.Scalar();
    if (std::find(named_.begin(), named_.end(), key) != named_.end()) continue;
    throw ConfigError(owner_ + "." + key + ": unknown key; allowed: [" + joined(named_) + "]" +
                      yaml_place(source_.file(), entry.first));
  }
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

void check_name(const std::string& name, const std::string& what, const YAML::Node& node,
                const Source& source) {
  if (is_name(name)) return;
  throw ConfigError(what + ": '" + name + "' is not a name (lower-case letters, digits, '_')" +
                    yaml_place(source.file(), node));
}

}  // namespace tocsin::deployment
