// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace tocsin::deployment {

/// The file that nodes come from, and what ${name} means in it.
class Source {
 public:
  /// Relative paths in the file are relative to its folder.
  Source(std::string file, std::map<std::string, std::string> variables);

  [[nodiscard]] const std::string& file() const { return file_; }
  /// `text` with every ${name} replaced; an unknown name is a ConfigError that points at `node`.
  [[nodiscard]] std::string expand(const std::string& text, const YAML::Node& node) const;
  /// `text` as an absolute path.
  [[nodiscard]] std::string path(const std::string& text) const;
  /// A copy of `node` with variables replaced and texts that start with ./ or ../ made absolute.
  [[nodiscard]] YAML::Node resolve(const YAML::Node& node) const;
  /// "file:line" of `node`.
  [[nodiscard]] std::string place(const YAML::Node& node) const;

 private:
  std::string file_;
  std::map<std::string, std::string> variables_;
};

/// A YAML map read key by key. Every error is a ConfigError naming owner.key, value, what is
/// allowed, and file:line.
class Section {
 public:
  /// Throws when `node` is not a map or names a key twice. `source` must outlive the section.
  Section(const YAML::Node& node, std::string owner, const Source& source);

  /// The node of `key`, undefined when absent.
  [[nodiscard]] YAML::Node find(const std::string& key);
  /// The text of `key` with variables replaced, or `fallback`.
  [[nodiscard]] std::string text(const std::string& key, const std::string& fallback);
  [[nodiscard]] std::string required_text(const std::string& key);
  /// A lower-case word with digits and underscores.
  [[nodiscard]] std::string required_name(const std::string& key);
  /// An absolute path of a readable file; empty when absent.
  [[nodiscard]] std::string file(const std::string& key);
  [[nodiscard]] int whole(const std::string& key, int fallback, int min, int max);
  [[nodiscard]] bool flag(const std::string& key, bool fallback);
  /// A list of texts; empty when absent.
  [[nodiscard]] std::vector<std::string> texts(const std::string& key);
  /// The nodes of a list; empty when absent.
  [[nodiscard]] std::vector<YAML::Node> items(const std::string& key);
  /// Throws on a key that no call has named.
  void reject_unknown_keys() const;
  [[noreturn]] void fail(const std::string& key, const std::string& what) const;

 private:
  YAML::Node node_;
  std::string owner_;
  const Source& source_;
  std::vector<std::string> named_;
};

/// The words with ", " between them.
[[nodiscard]] std::string joined(const std::vector<std::string>& words);

/// Throws ConfigError unless `name` is a lower-case word with digits and underscores.
void check_name(const std::string& name, const std::string& what, const YAML::Node& node,
                const Source& source);

}  // namespace tocsin::deployment
