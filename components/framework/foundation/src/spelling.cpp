// SPDX-License-Identifier: Apache-2.0
#include "foundation/spelling.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>

#include "foundation/joined.hpp"

namespace tocsin {
namespace {

/// Levenshtein distance, by rows.
std::size_t distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

std::string in_quotes(const std::string& word) { return "'" + word + "'"; }

}  // namespace

std::vector<std::string> similar(const std::vector<std::string>& words, const std::string& word) {
  std::vector<std::string> found;
  std::copy_if(words.begin(), words.end(), std::back_inserter(found),
               [&](const std::string& known) { return distance(known, word) <= 2; });
  return found;
}

std::string did_you_mean(const std::vector<std::string>& words, const std::string& word,
                         const std::string& list) {
  const std::vector<std::string> near = similar(words, word);
  if (near.empty()) return "; " + list + ": " + joined(words);
  return "; did you mean " + joined_of(near, in_quotes, " or ") + "?";
}

}  // namespace tocsin
