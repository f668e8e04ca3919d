// SPDX-License-Identifier: Apache-2.0
#include "report/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tocsin::report {
namespace {

constexpr double most_steps = 1e6;
constexpr double most_bins = 1e5;

/// Of each writer of each topic.
using Numbers = std::map<std::pair<std::string, std::string>, std::vector<std::uint64_t>>;

/// Sorts the numbers of each writer and leaves each there once. How many there are.
std::uint64_t distinct(Numbers& all) {
  std::uint64_t count = 0;
  for (auto& [writer, numbers] : all) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    count += numbers.size();
  }
  return count;
}

}  // namespace

double percentile(std::vector<double> values, double share) {
  if (values.empty()) return std::nan("");
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  const std::size_t index = std::max<std::size_t>(rank, 1) - 1;
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(index),
                   values.end());
  return values[index];
}

Spread spread_of(const std::vector<double>& values) {
  return {percentile(values, 0.5), percentile(values, 0.99)};
}

Fates fates_of(const std::vector<Arrival>& live, const std::vector<Arrival>& backfilled) {
  const auto numbers_of = [](const std::vector<Arrival>& arrivals, Numbers& numbers) {
    for (const Arrival& one : arrivals) {
      numbers[{one.topic, one.writer}].push_back(one.sequence);
    }
  };
  Numbers all;
  numbers_of(live, all);
  const std::uint64_t came_live = distinct(all);
  numbers_of(backfilled, all);
  Fates fates;
  fates.backfilled = distinct(all) - came_live;
  for (const auto& [writer, numbers] : all) {
    fates.lost += numbers.back() - numbers.front() + 1 - numbers.size();
  }
  return fates;
}

std::vector<double> ages(std::vector<Arrival> arrivals, double end_s, double step_s) {
  std::vector<double> result;
  if (arrivals.empty()) return result;
  std::sort(arrivals.begin(), arrivals.end(),
            [](const Arrival& a, const Arrival& b) { return a.received_s < b.received_s; });
  const double begin_s = arrivals.front().received_s;
  double newest_s = arrivals.front().sent_s;
  auto next = arrivals.begin();
  if (!std::isfinite(end_s - begin_s)) return result;
  step_s = std::max(step_s, (end_s - begin_s) / most_steps);
  const auto steps = static_cast<long>((end_s - begin_s) / step_s + 1e-9);
  for (long i = 0; i <= steps; ++i) {
    const double now_s = begin_s + static_cast<double>(i) * step_s;
    for (; next != arrivals.end() && next->received_s <= now_s; ++next) {
      newest_s = std::max(newest_s, next->sent_s);
    }
    result.push_back(now_s - newest_s);
  }
  return result;
}

double rate_bin_s(double begin_s, double end_s) {
  return std::max(1.0, std::ceil((end_s - begin_s) / most_bins));
}

std::vector<double> byte_rates(const std::vector<Arrival>& arrivals, double begin_s, double end_s) {
  if (!(end_s > begin_s) || !std::isfinite(end_s - begin_s)) return {};
  const double bin_s = rate_bin_s(begin_s, end_s);
  std::vector<double> rates(static_cast<std::size_t>(std::ceil((end_s - begin_s) / bin_s)));
  for (const Arrival& arrival : arrivals) {
    if (arrival.received_s < begin_s || arrival.received_s >= end_s) continue;
    rates[static_cast<std::size_t>((arrival.received_s - begin_s) / bin_s)] +=
        arrival.bytes / bin_s;
  }
  return rates;
}

}  // namespace tocsin::report
