// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <string>
#include <vector>

#include "foundation/yaml_sources.hpp"

namespace tocsin::deployment {

/// What a path that begins with ./ or ../ means.
enum class RelativePaths { of_the_file, as_written };

/// What ${name} means in a file.
using Variables = std::map<std::string, std::string>;

/// Replaces every ${name} in the texts of `node`, and makes texts that start with ./ or ../
/// absolute, relative to the folder of their file. The nodes stay where they were written; one that
/// is not there stays so. Throws ConfigError for an unknown name.
void expand(const YAML::Node& node, const YamlSources& sources, const Variables& variables,
            RelativePaths paths = RelativePaths::of_the_file);

/// Whether the files that a file names must be there.
enum class Named { must_be_readable, may_be_gone };

/// A YAML map read key by key. Every error is a ConfigError naming owner.key, value, what is
/// allowed, and file:line.
class Section {
 public:
  /// Throws when `node` is not a map, or has a key that is not in `allowed`.
  /// `sources` must outlive the section.
  Section(const YAML::Node& node, std::string owner, const YamlSources& sources,
          const std::vector<std::string>& allowed);
  /// A map of any keys.
  Section(const YAML::Node& node, std::string owner, const YamlSources& sources);

  /// The node of `key`, undefined when absent.
  [[nodiscard]] YAML::Node find(const std::string& key) const;
  /// The text of `key`, or `fallback`.
  [[nodiscard]] std::string text(const std::string& key, const std::string& fallback) const;
  [[nodiscard]] std::string required_text(const std::string& key) const;
  /// A lower-case word with digits and underscores.
  [[nodiscard]] std::string required_name(const std::string& key) const;
  /// An absolute path of a file; empty when absent.
  [[nodiscard]] std::string file(const std::string& key, Named named) const;
  /// An absolute path of a folder; empty when absent.
  [[nodiscard]] std::string folder(const std::string& key, Named named) const;
  [[nodiscard]] int whole(const std::string& key, int fallback, int min, int max) const;
  [[nodiscard]] bool flag(const std::string& key, bool fallback) const;
  /// A list of texts; empty when absent.
  [[nodiscard]] std::vector<std::string> texts(const std::string& key) const;
  /// The nodes of a list; empty when absent.
  [[nodiscard]] std::vector<YAML::Node> items(const std::string& key) const;
  [[noreturn]] void fail(const std::string& key, const std::string& what) const;

 private:
  const YAML::Node node_;
  const std::string owner_;
  const YamlSources& sources_;
};

/// Throws ConfigError unless `name` is a lower-case word with digits and underscores.
void check_name(const std::string& name, const std::string& what, const YAML::Node& node,
                const YamlSources& sources);

}  // namespace tocsin::deployment
