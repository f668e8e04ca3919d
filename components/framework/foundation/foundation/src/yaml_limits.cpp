// SPDX-License-Identifier: Apache-2.0
#include "yaml_limits.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"

namespace tocsin {
namespace {

std::string place(const YamlOrigin& origin, const YAML::Mark& mark) {
  return origin.has_lines ? fmt::format("{}:{}", origin.name, mark.line + 1) : origin.name;
}

/// What a node is with all its aliases replaced.
struct Extent {
  std::size_t nodes = 1;
  std::size_t depth = 0;  ///< lists and maps in each other
};

/// Counts along with the parser, which calls it for each node in the order of the text.
class Counter final : public YAML::EventHandler {
 public:
  explicit Counter(const YamlOrigin& origin) : origin_(origin) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ > 1) fail(mark, "a second YAML document; a file holds one");
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    if (is_key()) note(mark, "a key that is empty; a key is a text");
    add(mark, anchor, {});
  }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                const std::string& value) override {
    if (is_key()) add_key(mark, value);
    add(mark, anchor, {});
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    if (is_key()) note(mark, "a key that is an alias; a key is a text");
    const auto found = known_.find(anchor);
    if (found == known_.end()) fail(mark, "an alias within what it stands for, without end");
    add(mark, YAML::NullAnchor, found->second);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, anchor, false);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, anchor, true);
  }
  void OnMapEnd() override { close(); }

  /// Throws what was noted. After the whole text: the parser takes an opening bracket that has no
  /// end for a key first.
  void throw_noted() const {
    if (!noted_.empty()) throw ConfigError(noted_);
  }

 private:
  /// A list or map whose end is yet to come.
  struct Open {
    YAML::anchor_t anchor;
    bool is_map;
    std::size_t children;
    Extent extent;
    std::map<std::string, int> keys;  ///< and their lines
  };

  [[nodiscard]] std::string placed(const YAML::Mark& mark, const std::string& what) const {
    return place(origin_, mark) + ": " + what;
  }
  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& what) const {
    throw ConfigError(placed(mark, what));
  }
  void note(const YAML::Mark& mark, const std::string& what) {
    if (noted_.empty()) noted_ = placed(mark, what);
  }
  [[nodiscard]] bool is_key() const {
    return !open_.empty() && open_.back().is_map && open_.back().children % 2 == 0;
  }
  void add_key(const YAML::Mark& mark, const std::string& key) {
    const auto [first, is_new] = open_.back().keys.emplace(key, mark.line + 1);
    if (is_new) return;
    note(mark,
         fmt::format("key '{}' is given twice, first in line {}", printable(key), first->second));
  }
  void open(const YAML::Mark& mark, YAML::anchor_t anchor, bool is_map) {
    if (is_key()) note(mark, "a key that is a list or map; a key is a text");
    open_.push_back({anchor, is_map, 0, {1, 1}, {}});
    count(mark, {});
  }
  void close() {
    const Open closed = std::move(open_.back());
    open_.pop_back();
    take_in(closed.anchor, closed.extent);
  }
  void add(const YAML::Mark& mark, YAML::anchor_t anchor, Extent extent) {
    count(mark, extent);
    take_in(anchor, extent);
  }
  void count(const YAML::Mark& mark, Extent more) {
    nodes_ += more.nodes;
    if (nodes_ > most_yaml_nodes) {
      fail(mark, fmt::format("more than {} nodes, with what aliases stand for", most_yaml_nodes));
    }
    if (open_.size() + more.depth > deepest_yaml) {
      fail(mark, fmt::format("more than {} lists and maps in each other", deepest_yaml));
    }
  }
  /// Adds a whole node to the one that it is in.
  void take_in(YAML::anchor_t anchor, Extent extent) {
    if (anchor != YAML::NullAnchor) known_[anchor] = extent;
    if (open_.empty()) return;
    Open& parent = open_.back();
    ++parent.children;
    parent.extent.nodes += extent.nodes;
    parent.extent.depth = std::max(parent.extent.depth, extent.depth + 1);
  }

  const YamlOrigin& origin_;
  std::string noted_;
  std::size_t documents_ = 0;
  std::size_t nodes_ = 0;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, Extent> known_;
};

/// Whether a tab stands before the first other character of a line; they count from 0.
bool is_indented_by_tab(const std::string& text, int line) {
  std::istringstream lines(text);
  std::string read;
  for (int at = 0; at <= line; ++at) {
    if (!std::getline(lines, read)) return false;
  }
  return read.find('\t') < read.find_first_not_of(" \t");
}

/// What is wrong, in the parser's words unless they hide it.
std::string reason_of(const YAML::Exception& error, const std::string& text) {
  if (is_indented_by_tab(text, error.mark.line)) {
    return "a tab in the indentation; YAML is indented by spaces";
  }
  return error.msg;
}

}  // namespace

void check_yaml(const std::string& text, const YamlOrigin& origin) {
  if (text.size() > longest_yaml) {
    throw ConfigError(fmt::format("{}: has more than {} bytes", origin.name, longest_yaml));
  }
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  Counter counter(origin);
  try {
    while (parser.HandleNextDocument(counter)) {
    }
  } catch (const YAML::Exception& error) {
    throw ConfigError(place(origin, error.mark) + ": not valid YAML: " + reason_of(error, text));
  }
  counter.throw_noted();
}

}  // namespace tocsin
