// SPDX-License-Identifier: Apache-2.0
#include "decision/design/costs.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <utility>

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

/// Plays given decisions back; sample n decides slot n + 1.
class ReplayRule final : public Rule {
 public:
  explicit ReplayRule(std::vector<bool> send) : send_(std::move(send)) {}
  Decision while_active(double) override { return next(State::active); }
  Decision while_passive(double, int) override { return next(State::passive); }
  void entered(State) override {}
  void forget() override {}

 private:
  Decision next(State now) {
    ++at_;
    const bool send = at_ >= send_.size() || send_[at_];
    const bool change = send != (now == State::active);
    return {change, change ? Reason::foreseen : Reason::steady, 0, 0};
  }

  std::vector<bool> send_;
  std::size_t at_ = 0;
};

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

std::unique_ptr<Policy> make_oracle(const std::vector<Slot>& slots, double change,
                                    int th_max_samples) {
  std::vector<Slot> later(slots);
  if (!later.empty()) later.erase(later.begin());
  std::vector<bool> send = clairvoyant(later, change, th_max_samples).send;
  send.insert(send.begin(), true);
  constexpr double year_s = 3.2e7;
  return std::make_unique<Policy>("oracle", PolicyLimits{th_max_samples, year_s, year_s},
                                  std::make_unique<ReplayRule>(std::move(send)));
}

}  // namespace tocsin::decision
