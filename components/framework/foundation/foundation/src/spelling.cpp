// SPDX-License-Identifier: Apache-2.0
#include "foundation/spelling.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

#include "foundation/joined.hpp"

namespace tocsin {
namespace {

/// Optimal string alignment (Levenshtein with swaps of neighbours), by rows.
std::size_t distance(const std::string& a, const std::string& b) {
  using Row = std::vector<std::size_t>;
  Row before;
  Row above(b.size() + 1);
  std::iota(above.begin(), above.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    Row row(b.size() + 1, i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({replaced, above[j] + 1, row[j - 1] + 1});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = std::exchange(above, std::move(row));
  }
  return above.back();
}

std::size_t most_differences(const std::string& word) {
  if (word.size() <= 2) return 0;
  return word.size() <= 4 ? 1 : 2;
}

std::string in_quotes(const std::string& word) { return "'" + word + "'"; }

}  // namespace

std::vector<std::string> similar(const std::vector<std::string>& words, const std::string& word) {
  std::vector<std::string> found;
  std::copy_if(
      words.begin(), words.end(), std::back_inserter(found),
      [&](const std::string& known) { return distance(known, word) <= most_differences(known); });
  return found;
}

std::string suggestion(const std::vector<std::string>& words, const std::string& word) {
  const std::vector<std::string> near = similar(words, word);
  return near.empty() ? "" : "; did you mean " + joined_of(near, in_quotes, " or ") + "?";
}

std::string did_you_mean(const std::vector<std::string>& words, const std::string& word,
                         const std::string& list) {
  const std::string similar_ones = suggestion(words, word);
  return similar_ones.empty() ? "; " + list + ": " + joined(words) : similar_ones;
}

}  // namespace tocsin
