// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "report/statistics.hpp"

namespace tocsin::experiment {

/// A sample that was put on the link, whether it arrived or not.
struct Message {
  double sent_s;     ///< of a lost one: evenly between its neighbours that arrived
  double latency_s;  ///< NaN: it never arrived
  bool camera;       ///< a picture
  [[nodiscard]] bool lost() const { return !(latency_s >= 0); }
};

inline constexpr const char* camera_topic = "camera/image_raw/compressed";

/// Everything sent in [begin, end), as the gaps in each writer's sequence tell.
[[nodiscard]] std::vector<Message> messages_of(const std::vector<report::Arrival>& arrivals,
                                               double begin_s, double end_s);

}  // namespace tocsin::experiment
