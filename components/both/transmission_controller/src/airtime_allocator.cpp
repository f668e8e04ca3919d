// SPDX-License-Identifier: Apache-2.0
#include "airtime_allocator/airtime_allocator.hpp"

#include <algorithm>

namespace tocsin {
namespace {

/// Who uses so much of its share wants more.
constexpr double used_up = 0.8;
/// What who uses less gets, times its use, and of its even part at least.
constexpr double room = 1.5;
constexpr double idle_part = 0.25;

/// However busy the channel is, so much of it is ours to divide: 802.11 gives us our turns, too.
constexpr double most_strangers = 0.75;

bool is_share(double value) { return value >= 0 && value <= 1; }  // false for NaN

/// One that takes part in a division.
struct Claim {
  std::size_t vehicle;
  double weight;
  double wanted;
};

/// Max-min fair by weight: the least claims are met first, the others divide what remains. Where
/// all are met, they divide it too.
void give(double air, std::vector<Claim> claims, std::vector<AirtimeAllocator::Share>& shares) {
  std::sort(claims.begin(), claims.end(), [](const Claim& one, const Claim& other) {
    return one.wanted / one.weight < other.wanted / other.weight;
  });
  double all_weights = 0;
  for (const Claim& one : claims) all_weights += one.weight;
  double weights = all_weights;
  for (const Claim& one : claims) {
    const double given = std::min(one.wanted, air * one.weight / weights);
    shares[one.vehicle].share = given;
    air -= given;
    weights -= one.weight;
  }
  for (const Claim& one : claims) shares[one.vehicle].share += air * one.weight / all_weights;
}

}  // namespace

AirtimeAllocator::AirtimeAllocator(const Params& params, std::size_t vehicles)
    : params_(params), vehicles_(vehicles) {}

void AirtimeAllocator::on_use(std::size_t vehicle, const Use& use, Time now) {
  if (!is_share(use.used) || !is_share(use.share)) return;
  vehicles_[vehicle].heard = now;
  vehicles_[vehicle].use = use;
}

void AirtimeAllocator::on_busy(std::size_t vehicle, double busy, Time now) {
  Vehicle& one = vehicles_[vehicle];
  one.busy = is_share(busy) ? std::optional(busy) : std::nullopt;
  one.heard = now;
}

double AirtimeAllocator::free_air(Time now) const {
  std::vector<double> busy;
  double used = 0;
  for (const Vehicle& one : vehicles_) {
    if (!is_heard(one, now)) continue;
    used += one.use.used;
    if (one.busy) busy.push_back(*one.busy);
  }
  if (busy.empty()) return 1;
  const auto middle = busy.begin() + static_cast<std::ptrdiff_t>(busy.size() / 2);
  std::nth_element(busy.begin(), middle, busy.end());
  return 1 - std::clamp(*middle - used, 0.0, most_strangers);
}

double AirtimeAllocator::wanted(const Vehicle& vehicle, double even) {
  const Use& use = vehicle.use;
  if (use.waited || use.used >= used_up * std::min(use.share, even)) return 1;
  return std::max(room * use.used, idle_part * even);
}

AirtimeAllocator::Division AirtimeAllocator::divide(Time now) {
  if (!begun_) begun_ = now;
  const double fallback =
      vehicles_.size() > 1 ? params_.air / static_cast<double>(vehicles_.size()) : 1;
  Division division{std::vector<Share>(vehicles_.size(), Share{fallback, fallback}), 0};
  std::vector<Claim> claims;
  double weights = 0;
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    if (!is_heard(vehicles_[i], now)) continue;
    claims.push_back({i, weight_of(vehicles_[i]), 0});
    weights += claims.back().weight;
  }
  division.vehicles = now - *begun_ < starting ? vehicles_.size() : claims.size();
  if (claims.size() == 1) {
    division.shares[claims.front().vehicle].share = 1;
    return division;
  }
  const double air = params_.air * free_air(now);
  for (Claim& one : claims) {
    one.wanted = wanted(vehicles_[one.vehicle], air * one.weight / weights);
  }
  give(air, std::move(claims), division.shares);
  return division;
}

}  // namespace tocsin
