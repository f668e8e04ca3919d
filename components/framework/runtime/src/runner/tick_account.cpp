// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/tick_account.hpp"

#include <algorithm>
#include <cmath>

namespace tocsin {
namespace {

std::size_t bucket(std::int64_t ns, std::size_t buckets) {
  const auto positive = static_cast<unsigned long long>(std::max<std::int64_t>(ns, 1));
  return std::min(static_cast<std::size_t>(63 - __builtin_clzll(positive)), buckets - 1);
}

/// One writer: a plain addition, seen whole by the reader.
template <class Integer>
void add(std::atomic<Integer>& sum, Integer value) {
  sum.store(sum.load(std::memory_order_relaxed) + value, std::memory_order_relaxed);
}

}  // namespace

Duration TickFigures::quantile(double p, const TickFigures& earlier) const {
  const std::uint64_t count = ticks - earlier.ticks;
  if (count == 0) return Duration{0};
  const auto wanted = static_cast<std::uint64_t>(std::ceil(p * static_cast<double>(count)));
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i < buckets.size(); ++i) {
    seen += buckets[i] - earlier.buckets[i];
    if (seen >= wanted)
      return std::min(Duration{std::int64_t{2} << i}, std::max(longest, Duration{1}));
  }
  return longest;
}

void TickAccount::end(Time began, Time ended) {
  const std::int64_t ns = (ended - began).count();
  add(ticks_, std::uint64_t{1});
  add(total_, ns);
  add(buckets_[bucket(ns, buckets_.size())], std::uint64_t{1});
  if (ns > longest_.load(relaxed)) longest_.store(ns, relaxed);
  began_.store(0, relaxed);
}

void TickAccount::fail(const std::string& error) {
  const std::lock_guard<std::mutex> lock(error_mutex_);
  error_ = error;
  began_.store(0, relaxed);
  failed_.store(true, std::memory_order_release);
}

TickFigures TickAccount::read() {
  TickFigures figures;
  figures.ticks = ticks_.load(relaxed);
  figures.total = Duration{total_.load(relaxed)};
  figures.longest = Duration{longest_.exchange(0, relaxed)};
  for (std::size_t i = 0; i < buckets_.size(); ++i) figures.buckets[i] = buckets_[i].load(relaxed);
  const std::int64_t began = began_.load(relaxed);
  if (began != 0) figures.running_since = Time{Duration{began}};
  if (failed()) {
    const std::lock_guard<std::mutex> lock(error_mutex_);
    figures.error = error_;
  }
  return figures;
}

}  // namespace tocsin
