// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "foundation/parameters.hpp"
#include "foundation/time.hpp"
#include "geometry/pose.hpp"
#include "navigation/link_risk.hpp"

namespace tocsin {

/// What of the vehicle's stored topics the link has not delivered yet, as its router counts it.
struct StoreBacklog {
  std::uint64_t waiting = 0;     ///< samples
  std::uint64_t backfilled = 0;  ///< samples that were delivered late, since the router's start
};

/// Whether the vehicle stands still until its stored samples have crossed: at a goal that says so,
/// and on its way where it has a link and will lose it before all of them have crossed.
///
/// How fast they cross is what was seen last. It gives up after 10 s in which none has crossed, or
/// less than half of what did before, since a vehicle that stands in a fade stays in it; when
/// nothing is known of the store for 5 s; and when its time is over. Then not before the next goal
/// again. Pure; `now` must not decrease.
class SendStop {
 public:
  struct Params {
    double send_stop_s = 0;
    template <class Visitor>
    void visit(Visitor& v) {
      v("send_stop_s", send_stop_s, {0, 600},
        "[s] it stands at most, once on the way to each goal, to send what is stored before "
        "`link_risk` takes the link; 0: never");
    }
  };

  explicit SendStop(const Params& params) : params_(params) {}

  /// What the router says, about once a second.
  void on_store(const StoreBacklog& store, Time now);
  /// Whether to stand at the goal of this number, at most for `most_s`.
  [[nodiscard]] bool stands_at_goal(std::uint64_t goal, double most_s, Time now);
  /// Whether to stand here on the way to the goal of this number; `way` from here on. In the
  /// place ahead with the best link, and only where what waits takes longer than the link lasts.
  [[nodiscard]] bool stands_on_way(std::uint64_t goal, const geometry::Path& way, double speed_mps,
                                   const navigation::LinkRisk& risk, Time now);

 private:
  struct Stand {
    std::uint64_t goal;
    bool at_goal;
    Time since;
    Time looked;            ///< last at what has crossed
    std::uint64_t crossed;  ///< until then
    double usual_rate;      ///< [samples/s] before
    bool is_over = false;
  };
  void begin(std::uint64_t goal, bool at_goal, Time now);
  [[nodiscard]] bool is_worthwhile(Time now);
  [[nodiscard]] bool goes_on(double most_s, Time now);
  [[nodiscard]] bool may_begin(std::uint64_t goal, bool at_goal) const;
  [[nodiscard]] bool waits(std::uint64_t least, Time now) const;
  [[nodiscard]] double needed_s() const;

  Params params_;
  StoreBacklog store_;
  std::optional<Time> told_;
  double rate_ = 0;             ///< [samples/s] that have crossed; 0: not known
  std::optional<Stand> stand_;  ///< the last one
};

}  // namespace tocsin
