// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tocsin {

/// The words that differ from `word` by at most two letters.
[[nodiscard]] std::vector<std::string> similar(const std::vector<std::string>& words,
                                               const std::string& word);

/// "; did you mean 'a' or 'b'?" with the similar ones of `words`, else "; " and `list` with all of
/// them behind it: the end of an error text about an unknown `word`.
[[nodiscard]] std::string did_you_mean(const std::vector<std::string>& words,
                                       const std::string& word, const std::string& list);

}  // namespace tocsin
