// SPDX-License-Identifier: Apache-2.0
#include "sample_log/consumer.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <filesystem>
#include <system_error>

#include "foundation/error.hpp"
#include "foundation/printable.hpp"

namespace tocsin::sample_log {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 64;

void check_name(const std::string& name) {
  const bool fits =
      name.size() <= longest_name && std::all_of(name.begin(), name.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '_' || c == '-';
      });
  if (fits) return;
  throw ConfigError("consumer: '" + printable(name) +
                    "' is no name: up to 64 letters, digits, _ and -");
}

/// Topics have no dots.
std::string one_word(const std::string& topic) {
  std::string word = topic.substr(std::min(topic.find_first_not_of("/"), topic.size()));
  std::replace(word.begin(), word.end(), '/', '.');
  return word;
}

/// Makes the folder of a consumer's topic; empty: it has no name.
std::string made_folder(const std::string& folder, const ConsumerName& who) {
  if (who.name.empty()) return "";
  check_name(who.name);
  const fs::path path = fs::path(folder) / "consumers" / who.name / one_word(who.topic);
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw ConfigError(path.string() + ": cannot be made: " + error.message());
  return path;
}

std::optional<FolderLock> locked(const std::string& folder, const ConsumerName& who) {
  if (folder.empty()) return std::nullopt;
  try {
    return std::make_optional<FolderLock>(folder);
  } catch (const std::exception&) {
    throw ConfigError("consumer: another process is " + who.name + " of " + who.topic);
  }
}

std::optional<std::uint64_t> place_in(const StateFile& state) {
  const auto text = state.load();
  if (!text) return std::nullopt;
  std::uint64_t place = 0;
  const auto read = std::from_chars(text->data(), text->data() + text->size(), place);
  return read.ec == std::errc() ? std::optional(place) : std::nullopt;
}

}  // namespace

Consumer::Consumer(const std::string& folder, const ConsumerName& who, const LogStart& start)
    : Consumer(folder, who, start, made_folder(folder, who)) {}

Consumer::Consumer(const std::string& folder, const ConsumerName& who, const LogStart& start,
                   const std::string& own)
    : files_(folder),
      lock_(locked(own, who)),
      state_(own.empty() ? "" : own + "/place"),
      known_(own.empty() ? std::nullopt : place_in(state_)),
      is_back_(known_.has_value()),
      log_(files_, who.topic, known_ ? LogStart{LogStart::From::after, *known_} : start) {
  // A new name has its place from now on, whether something comes in this life or not.
  if (!commit()) throw ConfigError(own + ": a place cannot be written");
}

bool Consumer::commit() {
  if (!state_.keeps() || known_ == log_.place()) return true;
  if (!state_.save(std::to_string(log_.place()))) return false;
  known_ = log_.place();
  return true;
}

}  // namespace tocsin::sample_log
