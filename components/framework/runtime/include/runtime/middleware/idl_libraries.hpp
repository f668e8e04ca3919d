// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace tocsin {

/// The libraries of messages (`tocsin_idl_library`) that are installed in `prefixes`: lib<name>.so
/// of each package that has IDL files in share/<name>/idl. Sorted within a prefix.
[[nodiscard]] std::vector<std::filesystem::path> idl_libraries_in(
    const std::vector<std::filesystem::path>& prefixes);

/// Loads all that are installed, in the workspace of this program and in those that were sourced,
/// so that their types and topics are known (find_type, known_topics). One that cannot be loaded,
/// or that others than this user and root may change, is left out. Any thread, any number of times.
void load_idl_libraries();

}  // namespace tocsin
