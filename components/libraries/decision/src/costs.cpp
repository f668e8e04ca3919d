// SPDX-License-Identifier: Apache-2.0
#include "decision/costs.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>

#include "foundation/numbers.hpp"

namespace tocsin::decision {
namespace {

/// One slot of the programme: least cost by age of silence, 0 is speaking.
/// Returns the age that speaking in this slot came from.
std::uint32_t advance(std::vector<double>& cost, const Slot& slot, double change) {
  const auto silent = std::min_element(cost.begin() + 1, cost.end());
  const bool stay = cost[0] <= *silent + change;
  const auto from = stay ? 0 : static_cast<std::uint32_t>(silent - cost.begin());
  const double speak = slot.send + (stay ? cost[0] : *silent + change);
  std::move_backward(cost.begin(), cost.end() - 1, cost.end());
  for (std::size_t age = 1; age < cost.size(); ++age) cost[age] += slot.silent;
  cost[1] += change;
  cost[0] = speak;
  return from;
}

}  // namespace

std::vector<Slot> slots_of(const std::vector<bool>& bad, const SlotCosts& costs) {
  std::vector<Slot> slots;
  slots.reserve(bad.size());
  for (const bool is_bad : bad) {
    slots.push_back(is_bad ? Slot{costs.send_bad, costs.silent_bad} : Slot{0, costs.silent_good});
  }
  return slots;
}

Clairvoyant clairvoyant(const std::vector<Slot>& slots, double change, int th_max_samples) {
  assert(th_max_samples >= 1);
  std::vector<double> cost(static_cast<std::size_t>(th_max_samples) + 1, infinity);
  cost[0] = 0;
  std::vector<std::uint32_t> from;
  from.reserve(slots.size());
  for (const Slot& slot : slots) from.push_back(advance(cost, slot, change));
  const auto best = std::min_element(cost.begin(), cost.end());
  Clairvoyant result{*best, std::vector<bool>(slots.size())};
  auto age = static_cast<std::uint32_t>(best - cost.begin());
  for (std::size_t n = slots.size(); n-- > 0;) {
    result.send[n] = age == 0;
    age = age == 0 ? from[n] : age - 1;
  }
  return result;
}

double cost_of(const std::vector<Slot>& slots, double change, const std::vector<bool>& send) {
  assert(slots.size() == send.size());
  double cost = 0;
  bool speaking = true;
  for (std::size_t n = 0; n < slots.size(); ++n) {
    cost += send[n] ? slots[n].send : slots[n].silent;
    if (send[n] != speaking) cost += change;
    speaking = send[n];
  }
  return cost;
}

}  // namespace tocsin::decision
