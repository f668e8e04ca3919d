// SPDX-License-Identifier: Apache-2.0
#include "page_files.hpp"

#include <filesystem>
#include <optional>

#include "foundation/error.hpp"
#include "foundation/read_file.hpp"
#include "operator_server/access.hpp"

namespace tocsin::foxglove {
namespace {

constexpr std::size_t longest = std::size_t{16} << 20U;  // [byte] of a file

constexpr const char* no_page =
    "<!doctype html><meta charset=\"utf-8\"><title>Tocsin</title>"
    "<p>The operator's page is not installed here (package <code>operator_page</code>, or "
    "parameter "
    "<code>page</code>).</p>"
    "<p>Foxglove and Lichtblick connect to this address as a Foxglove WebSocket: "
    "<code>ws://</code> and what stands behind <code>http://</code> in the address line.</p>\n";

std::optional<std::string> bytes_of(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  try {
    return read_file(file.string(), longest);
  } catch (const ConfigError&) {
    return std::nullopt;
  }
}

}  // namespace

PageFile page_file(const std::string& folder, const std::string& path, bool takes_gzip) {
  const std::filesystem::path file = std::filesystem::path(folder) / path;
  if (!folder.empty() && takes_gzip) {
    if (auto bytes = bytes_of(file.string() + ".gz")) {
      return {200, content_type(path), std::move(*bytes), true};
    }
  }
  if (!folder.empty()) {
    if (auto bytes = bytes_of(file)) return {200, content_type(path), std::move(*bytes), false};
  }
  if (path == "index.html") return {404, "text/html; charset=utf-8", no_page, false};
  return {404, "text/plain; charset=utf-8", "there is no such file\n", false};
}

}  // namespace tocsin::foxglove
