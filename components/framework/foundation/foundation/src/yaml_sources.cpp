// SPDX-License-Identifier: Apache-2.0
#include "foundation/yaml_sources.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "foundation/error.hpp"
#include "foundation/read_file.hpp"
#include "yaml_limits.hpp"

namespace tocsin {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

}  // namespace

YamlSources::YamlSources(std::string file) : sources_{{std::move(file), 0, true}} {}

YAML::Node YamlSources::read(const std::string& path, const std::string& copy) {
  const std::string text = read_file(copy.empty() ? path : copy, longest_yaml);
  if (text.empty()) throw ConfigError(path + ": is empty");
  return add(text, {path, next_line_, true});
}

YAML::Node YamlSources::parse(const std::string& text, const std::string& name) {
  return add(text, {name, next_line_, false});
}

YAML::Node YamlSources::add(const std::string& text, Source source) {
  check_yaml(text, {source.name, source.is_file});
  const bool marked = text.rfind(byte_order_mark, 0) == 0;
  std::string numbered(static_cast<std::size_t>(source.first_line), '\n');  // moves every mark
  numbered += text.substr(marked ? byte_order_mark.size() : 0);
  if (numbered.empty() || numbered.back() != '\n') numbered += '\n';  // what follows is not in it
  const YAML::Node root = YAML::Load(numbered);
  next_line_ = static_cast<int>(std::count(numbered.begin(), numbered.end(), '\n')) + 1;
  sources_.push_back(std::move(source));
  return root;
}

const YamlSources::Source& YamlSources::source_of(const YAML::Node& node) const {
  static const Source none{"", 0, false};
  if (sources_.empty()) return none;
  const auto after =
      std::upper_bound(sources_.begin(), sources_.end(), node.Mark().line,
                       [](int line, const Source& source) { return line < source.first_line; });
  return after == sources_.begin() ? *after : *std::prev(after);
}

const std::string& YamlSources::file(const YAML::Node& node) const { return source_of(node).name; }

std::string YamlSources::place(const YAML::Node& node) const {
  // A map that was merged is where its first key is.
  if (node.Mark().is_null() && node.IsMap() && node.size() > 0) return place(node.begin()->first);
  const Source& source = source_of(node);
  const YAML::Mark mark = node.Mark();
  if (mark.is_null() || !source.is_file) return source.name;
  return source.name + ":" + std::to_string(mark.line + 1 - source.first_line);
}

std::string YamlSources::path(const YAML::Node& node, const std::string& text) const {
  const std::filesystem::path folder = std::filesystem::absolute(file(node)).parent_path();
  return (folder / text).lexically_normal().string();
}

std::vector<std::string> YamlSources::files() const {
  std::vector<std::string> names;
  for (const Source& source : sources_) {
    if (source.is_file) names.push_back(source.name);
  }
  return names;
}

}  // namespace tocsin
