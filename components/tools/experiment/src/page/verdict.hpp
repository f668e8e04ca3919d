// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "page/inference.hpp"
#include "page/results.hpp"

namespace tocsin::experiment {

/// What a paired difference says with 95 % confidence.
enum class Verdict { better, worse, undecided };

/// Of `ours` minus `other`.
[[nodiscard]] Verdict judge(const Estimate& difference, bool less_is_better);

/// The policy of the round with the best mean; null when none has an answer.
[[nodiscard]] const Group* best_of(const std::vector<const Group*>& round, Metric metric);

/// One sentence of HTML: whether `ours` beats `other` on the metric, by how much, and who is best
/// where it does not.
[[nodiscard]] std::string verdict_line(const Group& ours, const Group& other,
                                       const std::vector<const Group*>& round, Metric metric);

/// "TOCP-DSP" for tocp_dsp, "no policy" for none; other names as they are.
[[nodiscard]] std::string display_name(const std::string& policy);
/// "Mission A" for a.
[[nodiscard]] std::string mission_name(const std::string& mission);

}  // namespace tocsin::experiment
