// SPDX-License-Identifier: Apache-2.0
// The recordings of this computer that the page may open. Reads files; any thread.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "foundation/file_descriptor.hpp"

namespace tocsin::foxglove {

/// One file of a bag.
struct ListedBag {
  std::string path;  ///< below the folder, relative: `gcs/bag/bag_0.mcap`
  std::uint64_t bytes = 0;
  /// What its summary says; empty: it is still being written, or its writer was killed.
  struct Span {
    std::int64_t begin_ns;  ///< [ns since the Unix epoch] of its first message
    std::int64_t end_ns;
    std::uint64_t messages;
  };
  std::optional<Span> span;
};

/// The MCAP files at most four folders below `folder`, of which none is a link; the newest first,
/// at most 200. Files with names that a request cannot have are left out. An empty or absent
/// folder has none.
[[nodiscard]] std::vector<ListedBag> list_bags(const std::string& folder);

/// As JSON: `{"bags": [{"path", "bytes", "begin_s", "end_s", "messages"}, ...]}`, without the last
/// three of one that is not closed.
[[nodiscard]] std::string to_json(const std::vector<ListedBag>& bags);

struct OpenBag {
  FileDescriptor file;  ///< none: there is no such recording
  std::uint64_t bytes = 0;
};

/// Opens one of the files that `list_bags` names, and nothing else: no other name, nothing through
/// a link.
[[nodiscard]] OpenBag open_bag(const std::string& folder, const std::string& path);

/// Which bytes of a file are asked for.
struct ByteRange {
  std::uint64_t first = 0;
  std::uint64_t length = 0;
  bool is_part = false;  ///< false: it is the whole file
};

/// Of a HTTP header `Range`, RFC 9110: `bytes=5-9`, `bytes=5-`, `bytes=-5`. What is none of these
/// means the whole file, as the standard says; empty: the file has none of these bytes.
[[nodiscard]] std::optional<ByteRange> byte_range(std::string_view header, std::uint64_t bytes);

}  // namespace tocsin::foxglove
