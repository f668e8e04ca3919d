// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "report/summary.hpp"

namespace tocsin::report {

/// The summary for people: mission, decisions, network, a table of classes, a table of topics.
[[nodiscard]] std::string to_text(const Summary& summary);

/// Two runs side by side: latency, age and loss per class and of goals.
[[nodiscard]] std::string compare_text(const Summary& first, const Summary& second);

}  // namespace tocsin::report
