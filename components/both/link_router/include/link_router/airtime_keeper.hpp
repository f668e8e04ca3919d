// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "foundation/time.hpp"

namespace tocsin::router {

/// The share of the air that the site has told this router. Pure.
class AirtimeKeeper {
 public:
  /// Without a share for longer than this the fallback counts: the site tells one each second.
  static constexpr Duration silence_limit = std::chrono::seconds(5);

  /// [0, 1] each, received at `now`; what is outside is not taken. 1: no bound.
  void on_share(double share, double fallback, Time now);
  /// Whether one was ever told.
  [[nodiscard]] bool has_site() const { return told_.has_value(); }
  /// (0, 1) of the air; empty: all of it, or nothing was ever told.
  [[nodiscard]] std::optional<double> share(Time now) const;
  /// When share() will change without a further one; `never`: it will not.
  [[nodiscard]] Time deadline(Time now) const;

 private:
  struct Told {
    double share;
    double fallback;
    Time at;
  };
  std::optional<Told> told_;
};

}  // namespace tocsin::router
