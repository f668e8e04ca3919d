// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "foundation/numbers.hpp"

namespace tocsin::navigation {

/// The way from one place to another.
struct Leg {
  double length_m = infinity;  ///< infinite: there is none
  double silent_m = 0;         ///< on which the link is expected to be lost
};
/// From each place (row) to each other (column).
using Legs = std::vector<std::vector<Leg>>;

/// The places of a row of visits, and what the way along them costs.
struct VisitOrder {
  std::vector<std::size_t> places;
  Leg way;
};

/// The way along places in this order.
[[nodiscard]] VisitOrder along(const Legs& legs, std::vector<std::size_t> places);

/// An order of all places on which the link is lost least, of those whose way is longer than the
/// shortest that was found by at most this share; the first and the last place stay. Nearest
/// neighbour, then parts that are moved or turned round while that helps (2-opt and Or-opt, Or
/// 1976), so the best order is found nearly always, not always; it is no worse than the given one.
/// The same legs give the same order.
[[nodiscard]] VisitOrder ordered(const Legs& legs, double most_detour);

}  // namespace tocsin::navigation
