// SPDX-License-Identifier: Apache-2.0
#include "operator_server/bag_list.hpp"

#include <fcntl.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "foundation/error.hpp"
#include "mcap/format.hpp"
#include "mcap/reader.hpp"
#include "operator_server/access.hpp"

namespace tocsin::foxglove {
namespace {

namespace fs = std::filesystem;

constexpr int deepest = 4;                ///< folders below the one that is listed
constexpr std::size_t most_listed = 200;  ///< so that an answer stays short
constexpr std::uint64_t second = 1'000'000'000;

struct Found {
  fs::path file;
  fs::file_time_type written;
};

/// MCAP files that are there now; folders may come and go meanwhile.
std::vector<Found> mcap_files(const fs::path& folder) {
  std::vector<Found> found;
  std::error_code error;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, error);
  for (; !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
    if (at.depth() >= deepest) at.disable_recursion_pending();
    std::error_code gone;
    const bool is_bag = at->path().extension() == ".mcap" &&
                        at->symlink_status(gone).type() == fs::file_type::regular;
    const auto written = is_bag ? at->last_write_time(gone) : fs::file_time_type{};
    if (is_bag && !gone) found.push_back({at->path(), written});
  }
  return found;
}

/// A file that was closed ends as it begins; only that has a summary, which is read in no time.
bool is_closed(int file, std::uint64_t bytes) {
  std::array<std::uint8_t, mcap::magic.size()> end{};
  return bytes >= 2 * end.size() &&
         ::pread(file, end.data(), end.size(), static_cast<off_t>(bytes - end.size())) ==
             static_cast<ssize_t>(end.size()) &&
         end == mcap::magic;
}

std::optional<ListedBag::Span> span_of(const std::string& file) {
  try {
    const mcap::Reader reader(file);
    if (reader.damage().no_summary) return std::nullopt;
    const auto& statistics = reader.summary().statistics;
    return ListedBag::Span{static_cast<std::int64_t>(statistics.start_ns),
                           static_cast<std::int64_t>(statistics.end_ns), statistics.message_count};
  } catch (const ConfigError&) {
    return std::nullopt;
  }
}

std::optional<std::uint64_t> number_in(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::vector<ListedBag> list_bags(const std::string& folder) {
  if (folder.empty()) return {};
  auto files = mcap_files(folder);
  std::sort(files.begin(), files.end(), [](const Found& one, const Found& other) {
    return std::tie(other.written, one.file) < std::tie(one.written, other.file);
  });
  std::vector<ListedBag> bags;
  for (const Found& found : files) {
    if (bags.size() == most_listed) break;
    ListedBag bag;
    bag.path = found.file.lexically_relative(folder).string();
    const OpenBag open = open_bag(folder, bag.path);
    if (!open.file) continue;
    bag.bytes = open.bytes;
    if (is_closed(open.file.get(), open.bytes)) bag.span = span_of(found.file.string());
    bags.push_back(std::move(bag));
  }
  return bags;
}

std::string to_json(const std::vector<ListedBag>& bags) {
  auto list = nlohmann::json::array();
  for (const ListedBag& bag : bags) {
    nlohmann::json one{{"path", bag.path}, {"bytes", bag.bytes}};
    if (bag.span) {
      one["begin_s"] = static_cast<double>(bag.span->begin_ns) / static_cast<double>(second);
      one["end_s"] = static_cast<double>(bag.span->end_ns) / static_cast<double>(second);
      one["messages"] = bag.span->messages;
    }
    list.push_back(std::move(one));
  }
  return nlohmann::json{{"bags", list}}.dump();
}

OpenBag open_bag(const std::string& folder, const std::string& path) {
  const fs::path name(path);
  if (folder.empty() || !is_file_name(path) || name.extension() != ".mcap") return {};
  // Part by part, so that no link leads out of the folder.
  FileDescriptor at(::open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC));
  for (const fs::path& part : name.parent_path()) {
    if (!at) return {};
    at.reset(::openat(at.get(), part.c_str(), O_PATH | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  }
  if (!at) return {};
  constexpr int flags = O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC;
  OpenBag bag{FileDescriptor(::openat(at.get(), name.filename().c_str(), flags))};
  struct stat about {};
  if (!bag.file || ::fstat(bag.file.get(), &about) != 0 || !S_ISREG(about.st_mode)) return {};
  bag.bytes = static_cast<std::uint64_t>(about.st_size);
  return bag;
}

std::optional<ByteRange> byte_range(std::string_view header, std::uint64_t bytes) {
  const ByteRange whole{0, bytes, false};
  constexpr std::string_view unit = "bytes=";
  if (header.substr(0, unit.size()) != unit) return whole;
  const std::string_view range = header.substr(unit.size());
  const std::size_t dash = range.find('-');
  if (dash == std::string_view::npos) return whole;
  const auto first = number_in(range.substr(0, dash));
  const auto last = number_in(range.substr(dash + 1));
  if (dash == 0) {
    if (!last) return whole;
    const std::uint64_t length = std::min(*last, bytes);
    return length == 0 ? std::nullopt : std::optional(ByteRange{bytes - length, length, true});
  }
  const bool is_open = dash + 1 == range.size();
  if (!first || (!last && !is_open) || (last && *last < *first)) return whole;
  if (*first >= bytes) return std::nullopt;
  const std::uint64_t end = is_open ? bytes : std::min(*last, bytes - 1) + 1;
  return ByteRange{*first, end - *first, true};
}

}  // namespace tocsin::foxglove
