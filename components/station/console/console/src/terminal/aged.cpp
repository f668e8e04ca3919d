// SPDX-License-Identifier: Apache-2.0
#include "terminal/aged.hpp"

namespace tocsin::terminal {

Line aged(Line words, Duration age, const FreshnessLimits& limits) {
  switch (freshness(age, limits)) {
    case Freshness::fresh:
      return words;
    case Freshness::stale:
      for (Span& span : words) span.style = Style::old;
      words.push_back({", " + age_text(age) + " ago", Style::old});
      return words;
    case Freshness::unknown:
      break;
  }
  return {{"unknown for " + age_text(age), Style::old}};
}

}  // namespace tocsin::terminal
