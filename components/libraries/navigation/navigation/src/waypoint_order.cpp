// SPDX-License-Identifier: Apache-2.0
#include "navigation/waypoint_order.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace tocsin::navigation {
namespace {

constexpr double least_gain_m = 1e-6;
/// Metres of driving that a metre without link is worth: as LinkWayChooser, which gives 8 at most.
constexpr std::array<double, 5> worths{0, 1, 2, 4, 8};

using Order = std::vector<std::size_t>;

/// An order that is made cheaper; its first and its last place stay.
class Exchange {
 public:
  Exchange(const Legs& legs, double worth) : legs_(legs), worth_(worth) {}

  Order run() {
    Order order = nearest_first();
    while (turn_parts(order) || move_parts(order)) {
    }
    return order;
  }

 private:
  [[nodiscard]] double cost(std::size_t from, std::size_t to) const {
    const Leg& leg = legs_[from][to];
    return leg.length_m + worth_ * leg.silent_m;
  }
  [[nodiscard]] double cost(const Order& order) const {
    double sum = 0;
    for (std::size_t i = 1; i < order.size(); ++i) sum += cost(order[i - 1], order[i]);
    return sum;
  }

  [[nodiscard]] Order nearest_first() const {
    Order left;
    for (std::size_t i = 1; i + 1 < legs_.size(); ++i) left.push_back(i);
    Order order{0};
    while (!left.empty()) {
      const auto nearest =
          std::min_element(left.begin(), left.end(), [&](std::size_t a, std::size_t b) {
            return cost(order.back(), a) < cost(order.back(), b);
          });
      order.push_back(*nearest);
      left.erase(nearest);
    }
    if (legs_.size() > 1) order.push_back(legs_.size() - 1);
    return order;
  }

  bool take_if_better(Order& order, Order other) const {
    if (cost(other) >= cost(order) - least_gain_m) return false;
    order = std::move(other);
    return true;
  }

  [[nodiscard]] bool turn_parts(Order& order) const {
    for (std::size_t first = 1; first + 1 < order.size(); ++first) {
      for (std::size_t last = first + 1; last + 1 < order.size(); ++last) {
        Order other = order;
        std::reverse(at(other, first), at(other, last + 1));
        if (take_if_better(order, std::move(other))) return true;
      }
    }
    return false;
  }

  /// Up to three neighbours to another place in the order.
  [[nodiscard]] bool move_parts(Order& order) const {
    for (std::size_t size = 1; size <= 3; ++size) {
      for (std::size_t first = 1; first + size < order.size(); ++first) {
        if (move_part(order, first, size)) return true;
      }
    }
    return false;
  }
  [[nodiscard]] bool move_part(Order& order, std::size_t first, std::size_t size) const {
    Order rest = order;
    rest.erase(at(rest, first), at(rest, first + size));
    for (std::size_t to = 1; to < rest.size(); ++to) {
      Order other = rest;
      other.insert(at(other, to), at(order, first), at(order, first + size));
      if (take_if_better(order, std::move(other))) return true;
    }
    return false;
  }
  static Order::iterator at(Order& order, std::size_t i) {
    return order.begin() + static_cast<std::ptrdiff_t>(i);
  }

  const Legs& legs_;
  double worth_;
};

}  // namespace

VisitOrder along(const Legs& legs, std::vector<std::size_t> places) {
  Leg way{0, 0};
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Leg& leg = legs[places[i - 1]][places[i]];
    way.length_m += leg.length_m;
    way.silent_m += leg.silent_m;
  }
  return {std::move(places), way};
}

VisitOrder ordered(const Legs& legs, double most_detour) {
  Order given(legs.size());
  std::iota(given.begin(), given.end(), 0U);
  std::vector<VisitOrder> found{along(legs, given)};
  double shortest_m = found.front().way.length_m;
  for (const double worth : worths) {
    found.push_back(along(legs, Exchange(legs, worth).run()));
    shortest_m = std::min(shortest_m, found.back().way.length_m);
  }
  const double most_m = shortest_m * (1 + most_detour) + least_gain_m;
  const auto is_better = [most_m](const VisitOrder& a, const VisitOrder& b) {
    const bool a_fits = a.way.length_m <= most_m;
    const bool b_fits = b.way.length_m <= most_m;
    if (a_fits != b_fits) return a_fits;
    return std::pair(a.way.silent_m, a.way.length_m) < std::pair(b.way.silent_m, b.way.length_m);
  };
  return *std::min_element(found.begin(), found.end(), is_better);
}

}  // namespace tocsin::navigation
