// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "foundation/time.hpp"

namespace tocsin {

/// How far a value that was heard may be believed, by its age.
enum class Freshness {
  fresh,    ///< It is what is the case.
  stale,    ///< It was the case: shown as old, with its age.
  unknown,  ///< Too old to say anything, or never heard: not shown.
};

/// The ages at which a value stops being fresh, and at which it stops being worth showing.
struct FreshnessLimits {
  double stale_after_s = 3;
  double unknown_after_s = 30;
  template <class Visitor>
  void visit(Visitor& v) {
    v("stale_after_s", stale_after_s, {0.1, 3600},
      "[s] an older value is shown grey, with its age");
    v("unknown_after_s", unknown_after_s, {0.1, 86400},
      "[s] an older value is not shown; at least stale_after_s");
  }
};

/// `age` is that of the value, empty when there never was one. A limit itself is still within.
[[nodiscard]] inline Freshness freshness(std::optional<Duration> age,
                                         const FreshnessLimits& limits = {}) {
  if (!age || *age > seconds(limits.unknown_after_s)) return Freshness::unknown;
  return *age > seconds(limits.stale_after_s) ? Freshness::stale : Freshness::fresh;
}

/// An age for people, in the unit that keeps it below three digits: `12 s`, `3 min`, `20 h`.
/// A negative age is shown as 0 s.
[[nodiscard]] std::string age_text(Duration age);

}  // namespace tocsin
