// SPDX-License-Identifier: Apache-2.0
// What another policy would have decided lately: a question of the page, put to `tocsin decide`.
// Pure.
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "foundation/role.hpp"

namespace tocsin::foxglove {

struct WhatIf {
  Role host;                              ///< whose decisions
  std::string policy;                     ///< empty: the run's own
  std::vector<std::string> changes = {};  ///< `alpha=3`: parameters of the policy
};

/// Of `host=uxv&policy=tocp&alpha=3`. A text: why it is no question, one line. Whether there is
/// such a policy and parameter is for the tool to say; here only characters are looked at.
[[nodiscard]] std::variant<WhatIf, std::string> parse_what_if(const std::string& query);

/// The words of a command that decides a recording again.
[[nodiscard]] std::vector<std::string> what_if_command(const std::string& program,
                                                       const std::string& recording,
                                                       const WhatIf& question);

/// What the tool printed, without rows older than `window_s` before the last one, and without
/// folders of this computer. A text that is not the tool's stays as it is.
[[nodiscard]] std::string last_rows(const std::string& printed, double window_s);

}  // namespace tocsin::foxglove
