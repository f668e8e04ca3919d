// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "link_router/freeze_watch.hpp"

namespace tocsin::router {

/// With which of its sites a vehicle speaks: the first of them until it is silent while another one
/// is received; back to one that comes before it when that was received for long without a gap. So
/// an outage of the radio, in which all are silent, changes nothing, nor does a freeze of this
/// process. Pure; `now` must not decrease.
class SiteChoice {
 public:
  /// A site is silent when nothing was heard of it for so long: five values of the emergency stop.
  static constexpr Duration silent_after = std::chrono::milliseconds(500);
  /// So long is another one heard then, which takes over.
  static constexpr Duration heard_for = std::chrono::milliseconds(300);
  static constexpr Duration back_after = std::chrono::seconds(5);

  /// By preference; no two are equal. Fewer than two: there is nothing to choose.
  explicit SiteChoice(const std::vector<std::string>& sites);

  /// One that is not in the list changes nothing.
  void on_heard(const std::string& site, Time now);
  /// Whether another one is chosen than before.
  bool follow(Time now);
  /// Empty when there is nothing to choose.
  [[nodiscard]] std::string chosen() const;
  [[nodiscard]] std::set<std::string> others() const;

 private:
  struct Site {
    std::string name;
    std::optional<Time> last{};
    Time since{};  ///< heard without a gap
  };
  [[nodiscard]] static bool is_heard(const Site& site, Time now);
  [[nodiscard]] std::size_t best(Time now) const;

  std::vector<Site> sites_;
  std::size_t chosen_ = 0;
  FreezeWatch watch_;
};

}  // namespace tocsin::router
