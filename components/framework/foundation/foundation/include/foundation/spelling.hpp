// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace tocsin {

/// The words that differ from `word` by at most two letters, by one where they have 3 or 4. Two
/// letters that changed places are one.
[[nodiscard]] std::vector<std::string> similar(const std::vector<std::string>& words,
                                               const std::string& word);

/// "; did you mean 'a' or 'b'?" with the similar ones of `words`; empty when there are none: the
/// end of an error text that has listed `words`.
[[nodiscard]] std::string suggestion(const std::vector<std::string>& words,
                                     const std::string& word);

/// "; did you mean 'a' or 'b'?" with the similar ones of `words`, else "; " and `list` with all of
/// them behind it: the end of an error text about an unknown `word`.
[[nodiscard]] std::string did_you_mean(const std::vector<std::string>& words,
                                       const std::string& word, const std::string& list);

}  // namespace tocsin
