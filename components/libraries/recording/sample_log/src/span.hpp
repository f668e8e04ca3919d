// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <string>

#include "sample_log/sample_log.hpp"

namespace tocsin::sample_log {

/// One more sample of a topic.
inline void extend(std::map<std::string, LoggedSpan>& spans, const std::string& topic,
                   std::uint64_t time_ns) {
  LoggedSpan& span = spans[topic];
  span.topic = topic;
  span.first_ns = span.samples == 0 ? time_ns : std::min(span.first_ns, time_ns);
  span.last_ns = std::max(span.last_ns, time_ns);
  ++span.samples;
}

}  // namespace tocsin::sample_log
