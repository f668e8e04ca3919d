// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "link_classes.hpp"
#include "plan/experiment_file.hpp"
#include "report/recording.hpp"

namespace tocsin::experiment {

/// 100 s from 1000 s on: network quality once a second, paused and poor from 40 to 60 s, the link's
/// state once a second. Each tenth sample of network_quality is lost, latency is 20 ms.
inline report::Recording toy_recording() {
  report::Recording recording;
  recording.begin_s = 1000;
  recording.end_s = 1100;
  for (int i = 0; i < 100; ++i) {
    const double at_s = 1000 + i;
    const bool poor = i >= 40 && i < 60;
    recording.decisions.push_back({at_s, !poor, "toy", "steady", poor ? 30.0 : 80.0});
    recording.qualities.push_back({at_s, poor ? 50.0 : 0.0, -60, 5});
    recording.link.push_back({at_s, poor ? 5.0 : 20.0, 0.5, 0.1 * i, 1000.0 * i, 0});
    const auto sequence = static_cast<std::uint64_t>(i + 1);
    if (i % 10 != 5) {
      recording.arrivals[uxv_high].push_back(
          {at_s, at_s + 0.02, "network_quality", "1", sequence, 100});
    }
  }
  recording.written[uxv_high] = 100;
  recording.mission = {"toy", "done", 8, 9, 9, 88.5};
  return recording;
}

inline Timing toy_timing() {
  Timing timing;
  timing.duration_s = 100;
  timing.warm_up_s = 0;
  timing.observation_s = 10;
  timing.poor_below_snr_db = 10;
  return timing;
}

}  // namespace tocsin::experiment
