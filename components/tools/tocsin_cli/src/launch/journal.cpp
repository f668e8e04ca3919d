// SPDX-License-Identifier: Apache-2.0
#include "journal.hpp"

#include <algorithm>
#include <cstdio>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "line_splitter.hpp"

namespace tocsin::cli {
namespace {

/// As printable(), but with tabs, of which many a program makes its tables.
std::string shown(std::string_view text) {
  std::string line;
  for (;;) {
    const std::size_t tab = text.find('\t');
    line += printable(text.substr(0, tab), longest_line);
    if (tab == std::string_view::npos) return line;
    line += '\t';
    text.remove_prefix(tab + 1);
  }
}

}  // namespace

Journal::Journal(const std::filesystem::path& folder, bool show, bool colours)
    : folder_(folder), show_(show), colours_(colours) {
  std::filesystem::create_directories(folder_);
}

Journal::Log& Journal::log_of(const std::string& name) {
  const auto found = logs_.find(name);
  if (found != logs_.end()) return found->second;
  std::string file = name;
  std::replace(file.begin(), file.end(), '/', '.');
  Log log{std::ofstream(folder_ / (file + ".log"), std::ios::app), static_cast<int>(logs_.size())};
  return logs_.emplace(name, std::move(log)).first->second;
}

void Journal::append(Log& log, const std::string& text) {
  log.file.clear();  // a disk that was full may have room again
  log.file << text << std::endl;
}

void Journal::process_line(const std::string& name, const std::string& text) {
  Log& log = log_of(name);
  const std::string line = shown(text);
  append(log, line);
  if (!show_) return;
  std::printf("%s\n",
              prefixed(name, line, colours_ ? std::optional(log.colour) : std::nullopt).c_str());
  std::fflush(stdout);
}

void Journal::say(const std::string& text) {
  const std::string line = error_line(text);
  append(log_of("launch"), line);
  std::fprintf(stderr, "tocsin launch: %s\n", line.c_str());
}

}  // namespace tocsin::cli
