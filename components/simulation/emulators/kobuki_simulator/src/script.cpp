// SPDX-License-Identifier: Apache-2.0
#include "script.hpp"

#include <sstream>

#include "foundation/error.hpp"

namespace tocsin::kobuki {

Script::Script(const std::string& text, const std::string& file, Time start) {
  std::istringstream lines(text);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const std::string content = line.substr(0, line.find('#'));
    if (content.find_first_not_of(" \t\r") == std::string::npos) continue;
    add(content, file + ":" + std::to_string(number), start);
  }
}

void Script::add(const std::string& line, const std::string& place, Time start) {
  std::istringstream words(line);
  double at_s = -1;
  std::string command;
  if (!(words >> at_s) || !(at_s >= 0 && at_s <= 1e9)) {
    throw ConfigError(place + ": must begin with seconds since the start, 0 to 1e9");
  }
  std::getline(words >> std::ws, command);
  if (command.empty()) throw ConfigError(place + ": has no command after the seconds");
  const Time at = start + seconds(at_s);
  if (!entries_.empty() && at < entries_.back().at) {
    throw ConfigError(place + ": its time is before that of the line above");
  }
  entries_.push_back({at, command});
}

std::optional<std::string> Script::due(Time now) {
  if (now < next()) return std::nullopt;
  return entries_[done_++].command;
}

Time Script::next() const { return done_ < entries_.size() ? entries_[done_].at : never; }

}  // namespace tocsin::kobuki
