// SPDX-License-Identifier: Apache-2.0
#include "readme.hpp"

#include <fstream>
#include <regex>
#include <sstream>

#include "operator_process.hpp"
#include "stack.hpp"

namespace tocsin {
namespace {

constexpr const char* fence = "```";

bool starts_with(const std::string& line, const std::string& start) {
  return line.compare(0, start.size(), start) == 0;
}

/// The last word in backquotes; empty when there is none.
std::string last_quoted(const std::string& text) {
  const std::size_t end = text.rfind('`');
  if (end == std::string::npos || end == 0) return "";
  const std::size_t begin = text.rfind('`', end - 1);
  return begin == std::string::npos ? "" : text.substr(begin + 1, end - begin - 1);
}

std::string regex_of(const std::string& wanted) {
  static const std::regex special(R"([.^$|()\[\]{}*+?\\])");
  static const std::regex anything(R"((\\\.){3})");
  static const std::regex time_of_day(R"(\d\d:\d\d:\d\d\\\.\d{3})");
  std::string text = std::regex_replace(wanted, special, R"(\$&)");
  text = std::regex_replace(text, anything, ".*");
  return std::regex_replace(text, time_of_day, R"(\d\d:\d\d:\d\d\.\d{3})");
}

/// All fenced blocks.
std::vector<ReadmeBlock> blocks_of(const std::string& page) {
  std::vector<ReadmeBlock> blocks;
  std::ifstream file(page);
  std::string before;
  bool inside = false;
  int number = 0;
  for (std::string line; std::getline(file, line);) {
    ++number;
    if (starts_with(line, fence)) {
      inside = !inside;
      if (inside) blocks.push_back({line.substr(3), last_quoted(before), "", number + 1});
      before.clear();
    } else if (inside) {
      blocks.back().text += line + "\n";
    } else {
      before += line + "\n";
    }
  }
  return blocks;
}

ConsoleSession session_of(const ReadmeBlock& block) {
  ConsoleSession session{"", {}, block.line};
  std::istringstream lines(block.text);
  for (std::string line; std::getline(lines, line);) {
    if (starts_with(line, "$ ")) {
      session.script += line.substr(2) + "\n";
    } else {
      session.prints.push_back(line);
    }
  }
  return session;
}

}  // namespace

std::vector<ReadmeBlock> readme_files(const std::string& page) {
  std::vector<ReadmeBlock> files;
  for (ReadmeBlock& block : blocks_of(page)) {
    if (block.language != "console") files.push_back(std::move(block));
  }
  return files;
}

std::vector<ConsoleSession> readme_sessions(const std::string& page) {
  std::vector<ConsoleSession> sessions;
  for (const ReadmeBlock& block : blocks_of(page)) {
    if (block.language == "console") sessions.push_back(session_of(block));
  }
  return sessions;
}

std::string missing_line(const std::vector<std::string>& wanted, const std::string& output) {
  std::istringstream lines(output);
  for (const std::string& text : wanted) {
    const std::regex pattern(regex_of(text));
    std::string line;
    while (std::getline(lines, line) && !std::regex_match(line, pattern)) continue;
    if (!lines) return text;
  }
  return "";
}

std::string play(const ConsoleSession& session, const TemporaryFolder& folder,
                 const std::string& prelude, std::chrono::seconds limit) {
  const std::string number = std::to_string(session.line);
  const std::string output = "session" + number + ".out";
  const std::string script =
      folder.write("session" + number + ".sh",
                   "set -e\ncd " + folder.path() + "\n" + prelude + "\nset -x\n" + session.script);
  OperatorProcess shell(
      {"/usr/bin/env", "-u", "COLCON_PREFIX_PATH", "-u", "CMAKE_PREFIX_PATH", "/bin/bash", script},
      folder.path(output));
  const auto missing = [&] { return missing_line(session.prints, folder.read(output)); };
  const bool all = Stack::eventually(limit, [&] { return missing().empty(); });
  shell.end_all();
  if (all) return "";
  return "line " + number + ": '" + missing() + "' was not printed, but\n" + folder.read(output);
}

}  // namespace tocsin
