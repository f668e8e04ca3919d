// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tocsin::report {

/// One sample that has crossed the link.
struct Arrival {
  double sent_s = 0;      ///< [s] since the Unix epoch
  double received_s = 0;  ///< [s] since the Unix epoch
  std::string topic;
  std::string writer;          ///< changes when the writer restarts
  std::uint64_t sequence = 0;  ///< of the writer, from 1
  double bytes = 0;
};

/// Median and 99th percentile, both NaN without values.
struct Spread {
  double median;
  double p99;
};

/// The smallest value that at least `share` of the values do not exceed (nearest rank); NaN when
/// there are none. `share` in (0, 1].
[[nodiscard]] double percentile(std::vector<double> values, double share);
[[nodiscard]] Spread spread_of(const std::vector<double>& values);

/// What became of the samples of some topics.
struct Fates {
  std::uint64_t backfilled = 0;  ///< that came later, and not live
  std::uint64_t lost = 0;  ///< that never came: gaps in the sequence of each writer of each topic
};
[[nodiscard]] Fates fates_of(const std::vector<Arrival>& live,
                             const std::vector<Arrival>& backfilled = {});

/// How old [s] the newest sample of one topic was at the receiver, looked at every `step_s` from
/// the first arrival to `end_s`; less often where that were more than a million times, as when the
/// clock was set by years during the run.
[[nodiscard]] std::vector<double> ages(std::vector<Arrival> arrivals, double end_s, double step_s);

/// Width [s] of the bins of `byte_rates`: one second, more where that were more than 100,000.
[[nodiscard]] double rate_bin_s(double begin_s, double end_s);

/// Received bytes per second in bins of `rate_bin_s` from `begin_s` to `end_s`.
[[nodiscard]] std::vector<double> byte_rates(const std::vector<Arrival>& arrivals, double begin_s,
                                             double end_s);

}  // namespace tocsin::report
