// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tocsin {

/// Where programs are looked for, best first.
using Folders = std::vector<std::filesystem::path>;

/// The file of the running program.
[[nodiscard]] std::filesystem::path own_program();

/// The folder of `program`; when it is `<install>/<package>/bin`, all `<install>/*/bin`; then the
/// folders of `path_variable` (as in $PATH).
[[nodiscard]] Folders program_folders(const std::filesystem::path& program,
                                      const std::string& path_variable);

/// The program folders of the running program and of $PATH.
[[nodiscard]] Folders program_folders();

/// The first executable file `name`; a name with a slash is taken as it is.
[[nodiscard]] std::optional<std::filesystem::path> find_program(const std::string& name,
                                                                const Folders& folders);

/// VERB of every executable tocsin-VERB, sorted, each once.
[[nodiscard]] std::vector<std::string> find_verbs(const Folders& folders);

/// The installed folder share/tocsin beside `program`, or of the package bringup in an isolated
/// install; `<prefix>/share/tocsin` when neither is there.
[[nodiscard]] std::filesystem::path share_folder(const std::filesystem::path& program);

}  // namespace tocsin
