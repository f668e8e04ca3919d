// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <initializer_list>
#include <utility>

#include "link_classes.hpp"
#include "metrics/metrics.hpp"

namespace tocsin::experiment {

/// When the runs of these tests begin.
inline constexpr double begin_s = 1000;

/// A run of 100 s that is filled sample by sample; times count from its begin.
class Hand {
 public:
  Hand() {
    recording_.begin_s = begin_s;
    recording_.end_s = begin_s + 100;
    timing_.duration_s = 100;
    timing_.warm_up_s = 0;
    timing_.observation_s = 10;
    timing_.poor_below_snr_db = 10;
  }
  Hand& warm_up(double s) {
    timing_.warm_up_s = s;
    return *this;
  }
  /// Sample `sequence` of a topic, sent at `sent_s`, that took `latency_s`.
  Hand& arrives(const report::LinkClass& link_class, const char* topic, std::uint64_t sequence,
                double sent_s, double latency_s) {
    const double at_s = begin_s + sent_s;
    recording_.arrivals[link_class].push_back({at_s, at_s + latency_s, topic, "1", sequence, 50});
    return *this;
  }
  Hand& written(const report::LinkClass& link_class, std::uint64_t count) {
    recording_.written[link_class] = count;
    return *this;
  }
  Hand& decides(double at_s, bool active, double qni) {
    recording_.decisions.push_back({begin_s + at_s, active, "toy", "steady", qni});
    return *this;
  }
  Hand& probes(double at_s, double per) {
    recording_.qualities.push_back({begin_s + at_s, per, -60, 5});
    return *this;
  }
  /// The link's SNR second by second: pairs of (from this second on, value).
  Hand& link(std::initializer_list<std::pair<int, double>> steps) {
    double snr_db = 0;
    for (int i = 0; i <= 100; ++i) {
      for (const auto& [from_s, value] : steps) snr_db = i == from_s ? value : snr_db;
      recording_.link.push_back({begin_s + i, snr_db, 0.5, 0.2 * i, 25'000.0 * i, 0});
    }
    return *this;
  }
  Hand& done_after(double s) {
    recording_.mission = {"toy", "done", 8, 9, 9, s};
    return *this;
  }
  [[nodiscard]] double value(Metric metric) const {
    return measure(recording_, timing_).values[index_of(metric)];
  }
  [[nodiscard]] Observation observation(std::size_t i) const {
    return measure(recording_, timing_).series.at(i);
  }

 private:
  report::Recording recording_;
  Timing timing_;
};

}  // namespace tocsin::experiment
