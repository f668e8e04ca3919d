// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

namespace tocsin::cli {

/// Where lines go: the terminal, with the name of their process, and a log file for each process.
class Journal {
 public:
  /// `show` is false when a process owns the terminal: then lines of the others go to files only.
  Journal(const std::filesystem::path& folder, bool show, bool colours);
  /// One line of the process `name`; its log is `<folder>/<name with . for />.log`. On a full disk
  /// a line is lost, and later ones are written again when there is room.
  void process_line(const std::string& name, const std::string& text);
  /// One line of the launcher itself, to stderr and to `launch.log`.
  void say(const std::string& text);

 private:
  struct Log {
    std::ofstream file;
    int colour;
  };
  Log& log_of(const std::string& name);
  static void append(Log& log, const std::string& text);

  std::filesystem::path folder_;
  bool show_;
  bool colours_;
  std::map<std::string, Log> logs_;
};

}  // namespace tocsin::cli
