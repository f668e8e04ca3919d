// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tocsin {

/// What a name must be, for error texts.
inline constexpr const char* name_rule = "a lower-case letter, then such letters, digits and '_'";

/// Whether `text` can name a host, process or component: it is part of file names and topics.
[[nodiscard]] bool is_name(std::string_view text);

// Hosts, processes and components have names that are paths: `uxv`, `uxv/payload`,
// `uxv/payload/camera`. Commands print them with or without a slash in front, and whole or in part;
// whatever is printed is understood.

/// The words of a path: `/uxv/payload` and `uxv/payload` are uxv and payload. Empty words, as of
/// `//` or of an end with a slash, are left out.
[[nodiscard]] std::vector<std::string> words_of_path(std::string_view path);

/// Whether `given` means the thing at `path`: its words are words of the path, in their order, and
/// the last of both is the same. `/uxv/camera`, `payload/camera` and `camera` mean
/// `uxv/payload/camera`.
[[nodiscard]] bool means(std::string_view given, std::string_view path);

/// The one of `paths` that `given` means; the whole path goes before a part of a longer one. Throws
/// ConfigError with `what` ("process") and the choice when there is none, or more than one.
[[nodiscard]] std::string resolve_path(const std::string& given,
                                       const std::vector<std::string>& paths,
                                       const std::string& what);

/// `name` without a slash in front: names of topics, hosts and nodes as ROS prints them.
[[nodiscard]] std::string without_slash(std::string name);

}  // namespace tocsin
