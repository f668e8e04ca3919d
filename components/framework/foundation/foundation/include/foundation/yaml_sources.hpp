// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace YAML {
class Node;
}

namespace tocsin {

/// Where the nodes of a YAML tree were written, wherever merging has put them.
///
/// The lines of all its files are numbered through, as a compiler does it: the mark of a node then
/// tells its file, too.
class YamlSources {
 public:
  YamlSources() = default;
  /// For nodes that were read elsewhere, all from `file`.
  YamlSources(std::string file);
  YamlSources(const char* file) : YamlSources(std::string(file)) {}

  /// Reads the one YAML document of a file; every YAML text of the stack comes in here or in
  /// parse(). Throws ConfigError with file, line and reason when it cannot be read, is empty, is
  /// not YAML, or would take more than a file of ours can need: 512 KiB, 32 lists and maps in each
  /// other, 100,000 nodes (an alias counts as what it stands for); and for an alias within what it
  /// stands for, a key that is given twice or is no text, and a second document. `copy`: where the
  /// same text is read instead; empty: at `path`, which errors name in any case.
  [[nodiscard]] YAML::Node read(const std::string& path, const std::string& copy = "");
  /// The same from a text that is no file; `name` stands for it in errors, without lines. An empty
  /// text is a null node.
  [[nodiscard]] YAML::Node parse(const std::string& text, const std::string& name);

  /// The file that `node` was written in; the first one for a node that a program has made.
  [[nodiscard]] const std::string& file(const YAML::Node& node) const;
  /// "file:line" of `node`; only "file" when its line is not known.
  [[nodiscard]] std::string place(const YAML::Node& node) const;
  /// `text`, a path that `node` says, as an absolute one: relative to the folder of its file.
  [[nodiscard]] std::string path(const YAML::Node& node, const std::string& text) const;
  /// All files, in the order of their reading.
  [[nodiscard]] std::vector<std::string> files() const;

 private:
  struct Source {
    std::string name;
    int first_line;  ///< in the numbering of all
    bool is_file;
  };
  [[nodiscard]] const Source& source_of(const YAML::Node& node) const;
  YAML::Node add(const std::string& text, Source source);

  std::vector<Source> sources_;
  int next_line_ = 0;
};

}  // namespace tocsin
