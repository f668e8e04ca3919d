// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tocsin::foxglove {

/// What a request for a file of the page gets.
struct PageFile {
  unsigned status = 200;
  const char* type = "text/plain; charset=utf-8";
  std::string bytes;
  bool zipped = false;
};

/// What the page may load and do: all of it comes from here, and it talks to nobody else.
inline constexpr const char* page_policy =
    "default-src 'self'; img-src 'self' data: blob:; style-src 'self' 'unsafe-inline'; "
    "connect-src 'self' ws: wss:; frame-ancestors 'none'";

/// `path` as `judge` gives it. `takes_gzip`: `path`.gz is served when it is there. Without a page
/// the index says so, and how other clients connect.
[[nodiscard]] PageFile page_file(const std::string& folder, const std::string& path,
                                 bool takes_gzip);

}  // namespace tocsin::foxglove
