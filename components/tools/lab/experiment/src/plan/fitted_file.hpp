// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <vector>

namespace tocsin::experiment {

/// Parameters of the transmission controller ("key=value") by mission and policy, as `tocsin
/// experiment fit` writes them. The policy `every_policy` stands for what all have in common.
using Fitted = std::map<std::string, std::map<std::string, std::vector<std::string>>>;

inline constexpr const char* every_policy = "every_policy";

/// The mission's key of fit number 1, 2, ...: "a", "a/2", ... The first is that of files with one.
[[nodiscard]] std::string fitted_key(const std::string& mission, int fit);
/// The fit that run `index` (1, 2, ...) belongs to: runs take `fits` in turn.
[[nodiscard]] int fit_of(int index, int fits);

/// What holds for a policy in a mission: of every policy first, then its own.
[[nodiscard]] std::vector<std::string> settings_for(const Fitted& fitted,
                                                    const std::string& mission,
                                                    const std::string& policy);

/// Throws ConfigError with file and line when it is not such a file.
[[nodiscard]] Fitted load_fitted(const std::string& path);
/// The same of a text that was read from `path`.
[[nodiscard]] Fitted parse_fitted(const std::string& text, const std::string& path);
/// The text of the file; each line of `comment` becomes a comment at its begin.
[[nodiscard]] std::string fitted_text(const Fitted& fitted, const std::string& comment);

}  // namespace tocsin::experiment
