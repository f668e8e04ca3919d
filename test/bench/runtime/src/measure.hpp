// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tocsin::bench {

/// [ns] of the steady clock.
[[nodiscard]] std::int64_t now_ns();

/// Durations in nanoseconds, for the median and the 99th percentile.
class Series {
 public:
  void add(std::int64_t ns) { values_.push_back(ns); }
  void add(const Series& other) {
    values_.insert(values_.end(), other.values_.begin(), other.values_.end());
  }
  [[nodiscard]] bool empty() const { return values_.empty(); }
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  /// [ns], `share` in [0, 1]; 0 when there is none.
  [[nodiscard]] double percentile(double share) const;
  /// How many are longer than `ns`.
  [[nodiscard]] int above(std::int64_t ns) const;
  /// "median / p99" in microseconds.
  [[nodiscard]] std::string text() const;

 private:
  std::vector<std::int64_t> values_;
};

/// "median [low, high]" of shares, with the 95 % confidence interval of their median by order
/// statistics: it needs no law of their distribution.
[[nodiscard]] std::string share_text(std::vector<double> shares);

/// A number of /proc/self/smaps_rollup or status: "Pss" [kB], "Threads".
[[nodiscard]] long proc_number(const std::string& file, const std::string& key);

/// CPU time of a process and its threads so far [s].
[[nodiscard]] double cpu_s(int process);

/// What `command` printed.
[[nodiscard]] std::string output_of(const std::string& command);

}  // namespace tocsin::bench
