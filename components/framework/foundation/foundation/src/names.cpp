// SPDX-License-Identifier: Apache-2.0
#include "foundation/names.hpp"

#include <algorithm>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/printable.hpp"
#include "foundation/spelling.hpp"

namespace tocsin {

bool is_name(std::string_view text) {
  const auto letter = [](char c) { return c >= 'a' && c <= 'z'; };
  const auto allowed = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
  return !text.empty() && letter(text.front()) && std::all_of(text.begin(), text.end(), allowed);
}
namespace {

std::string listed(const std::vector<std::string>& texts) { return "[" + joined(texts) + "]"; }

/// The paths and the last word of each, by which it may be called.
std::vector<std::string> with_last_words(const std::vector<std::string>& paths) {
  std::vector<std::string> all = paths;
  for (const std::string& path : paths) all.push_back(path.substr(path.rfind('/') + 1));
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace

std::vector<std::string> words_of_path(std::string_view path) {
  std::vector<std::string> words;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('/'), path.size());
    if (end > 0) words.emplace_back(path.substr(0, end));
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return words;
}

bool means(std::string_view given, std::string_view path) {
  const auto wanted = words_of_path(given);
  const auto words = words_of_path(path);
  if (wanted.empty() || words.empty() || wanted.back() != words.back()) return false;
  auto next = wanted.begin();
  for (const std::string& word : words) {
    if (next != wanted.end() && word == *next) ++next;
  }
  return next == wanted.end();
}

std::string resolve_path(const std::string& given, const std::vector<std::string>& paths,
                         const std::string& what) {
  const auto wanted = words_of_path(given);
  std::vector<std::string> meant;
  for (const std::string& path : paths) {
    if (words_of_path(path) == wanted) return path;
    if (means(given, path)) meant.push_back(path);
  }
  if (meant.size() == 1) return meant.front();
  if (meant.empty()) {
    throw ConfigError(printable(given) + ": no such " + what + "; allowed: " + listed(paths) +
                      suggestion(with_last_words(paths), without_slash(given)));
  }
  throw ConfigError(printable(given) + ": which " + what + "? One of " + listed(meant));
}

std::string without_slash(std::string name) {
  name.erase(0, std::min(name.find_first_not_of('/'), name.size()));
  return name;
}

}  // namespace tocsin
