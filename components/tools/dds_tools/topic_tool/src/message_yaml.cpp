// SPDX-License-Identifier: Apache-2.0
#include "message_yaml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/spelling.hpp"

namespace tocsin::topic_tool {
namespace {

/// A message as it is printed.
struct Tree {
  enum class Kind { scalar, map, list } kind = Kind::scalar;
  std::string text;                                   ///< of a scalar
  std::vector<std::pair<std::string, Tree>> members;  ///< of a map; of a list without names
};

/// YAML's own words for numbers that are none, and a point in every other.
std::string float_text(const std::string& digits) {
  if (digits == "nan" || digits == "-nan") return ".nan";
  if (digits == "inf") return ".inf";
  if (digits == "-inf") return "-.inf";
  return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
}

std::string shortest(float value) {
  char text[32];
  const auto end = std::to_chars(std::begin(text), std::end(text), value);
  return {std::begin(text), end.ptr};
}

/// Whether YAML would read the text as itself: words that begin with a letter, a blank between.
bool is_plain(const std::string& text) {
  const auto is_letter = [](char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '/' || c == '_';
  };
  if (text.empty() || !is_letter(text.front()) || text.back() == ' ') return false;
  char before = 'a';
  for (const char c : text) {
    const bool digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
    const bool fits = is_letter(c) || digit || c == '.' || c == '+' || c == '-';
    if (!fits && (c != ' ' || before == ' ')) return false;
    before = c;
  }
  static const std::set<std::string> words{"true", "false", "null", "yes", "no", "on", "off"};
  std::string lower = text;
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return words.count(lower) == 0;
}

std::string quoted(const std::string& text) {
  if (is_plain(text)) return text;
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? "''" : std::string(1, c);
  return result + "'";
}

/// Makes the tree.
class Planter final : public FieldVisitor {
 public:
  explicit Planter(const EchoOptions& options) : options_(options) {}
  void number(const char* name, double value) override {
    add(name, float_text(shortest_text(value)));
  }
  void single(const char* name, float value) override { add(name, float_text(shortest(value))); }
  void integer(const char* name, std::int64_t value) override { add(name, std::to_string(value)); }
  void boolean(const char* name, bool value) override { add(name, value ? "true" : "false"); }
  void text(const char* name, const std::string& value) override {
    if (options_.no_texts) return add(name, fmt::format("'<string length: <{}>>'", value.size()));
    const bool longer = options_.longest > 0 && value.size() > options_.longest;
    const std::string shown = longer ? value.substr(0, options_.longest) + "..." : value;
    add(name, quoted(printable(shown, shown.size())));
  }
  void bytes(const char* name, const std::uint8_t* data, std::size_t size) override {
    begin_list(name, size);
    const std::size_t shown = options_.longest > 0 ? std::min(size, options_.longest + 1) : size;
    for (std::size_t i = 0; i < shown; ++i) integer(name, data[i]);
    end_list();
  }
  void begin_struct(const char* name) override { open(name, Tree::Kind::map); }
  void end_struct() override { path_.pop_back(); }
  void begin_list(const char* name, std::size_t size) override {
    if (!options_.no_lists) return open(name, Tree::Kind::list);
    add(name, fmt::format("'<sequence type: {} elements>'", size));
    path_.push_back(&beyond_);
    beyond_ = {Tree::Kind::list, "", {}};
  }
  void end_list() override { path_.pop_back(); }
  [[nodiscard]] Tree take() { return std::move(root_); }

 private:
  /// Of a list that shows no more.
  [[nodiscard]] bool is_full() {
    return options_.longest > 0 && at().kind == Tree::Kind::list &&
           at().members.size() >= options_.longest;
  }
  /// Of a list that is full: says that there is more, once.
  void cut(const char* name) {
    if (at().members.size() > options_.longest) return;
    at().members.push_back({name, {Tree::Kind::scalar, "'...'", {}}});
  }
  Tree& at() { return path_.empty() ? root_ : *path_.back(); }
  void add(const char* name, std::string text) {
    if (name == std::string_view("structure_needs_at_least_one_member")) return;  // of nothing
    if (is_full()) return cut(name);
    at().members.push_back({name, {Tree::Kind::scalar, std::move(text), {}}});
  }
  void open(const char* name, Tree::Kind kind) {
    if (is_full()) {
      cut(name);
      path_.push_back(&beyond_);
      beyond_ = {kind, "", {}};
      return;
    }
    at().members.push_back({name, {kind, "", {}}});
    path_.push_back(&at().members.back().second);
  }
  const EchoOptions& options_;
  Tree root_{Tree::Kind::map, "", {}};
  Tree beyond_;  ///< takes what is cut
  std::vector<Tree*> path_;
};

void print(const Tree& tree, std::size_t indent, std::string& out);

/// What stands behind "key:" or "-".
void print_value(const Tree& tree, std::size_t indent, std::string& out) {
  if (tree.kind == Tree::Kind::scalar) {
    out += " " + tree.text + "\n";
  } else if (tree.members.empty()) {
    out += tree.kind == Tree::Kind::map ? " {}\n" : " []\n";
  } else {
    out += "\n";
    print(tree, tree.kind == Tree::Kind::map ? indent + 2 : indent, out);
  }
}

void print(const Tree& tree, std::size_t indent, std::string& out) {
  const std::string space(indent, ' ');
  for (const auto& [name, member] : tree.members) {
    if (tree.kind == Tree::Kind::map) {
      out += space + name + ":";
      print_value(member, indent, out);
      continue;
    }
    if (member.kind != Tree::Kind::map || member.members.empty()) {
      out += space + "-";
      print_value(member, indent + 2, out);
      continue;
    }
    std::string inner;  // the first line of a map stands behind the dash
    print(member, indent + 2, inner);
    out += space + "- " + inner.substr(indent + 2);
  }
}

const Tree& member_of(const Tree& tree, const std::string& path, const TypeInfo& type) {
  const Tree* at = &tree;
  for (std::size_t begin = 0; begin <= path.size();) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    const std::string name = path.substr(begin, end - begin);
    std::vector<std::string> known;
    const Tree* next = nullptr;
    for (const auto& [member, child] : at->members) {
      known.push_back(member);
      if (at->kind == Tree::Kind::map && member == name) next = &child;
    }
    if (next == nullptr) {
      throw ConfigError("--field " + path + ": " + type.name + " has no field '" + name + "'" +
                        did_you_mean(known, name, "fields"));
    }
    at = next;
    begin = end + 1;
  }
  return *at;
}

}  // namespace

std::string to_yaml(const TypeInfo& type, const void* message, const EchoOptions& options) {
  Planter planter(options);
  type.visit(message, planter);
  const Tree root = planter.take();
  std::string out;
  if (options.field.empty()) {
    print(root, 0, out);
    return out.empty() ? "{}\n" : out;
  }
  const Tree& member = member_of(root, options.field, type);
  if (member.kind == Tree::Kind::scalar) return member.text + "\n";
  if (member.members.empty()) return member.kind == Tree::Kind::map ? "{}\n" : "[]\n";
  print(member, 0, out);
  return out;
}

}  // namespace tocsin::topic_tool
