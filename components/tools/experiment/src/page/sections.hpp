// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "page/document.hpp"
#include "page/results.hpp"

/// The parts of the report, in their order. Each adds nothing when its data are not there.
namespace tocsin::experiment {

void add_overview(const Results& results, Document& document);
/// Whether TOCP-DSP beats the thesis's other policies, from the confidence intervals.
void add_verdicts(const Results& results, Document& document);
/// Figures 43 to 52 of the thesis, and its numbers beside ours.
void add_thesis(const Results& results, Document& document);
/// What the radio was: SNR along the path, share of poor time, files.
void add_channels(const Results& results, Document& document);
/// Distributions over the runs of the thesis's policies.
void add_distributions(const Results& results, Document& document);
/// All metrics of every policy of every set of kind thesis and comparison.
void add_comparisons(const Results& results, Document& document);
/// All policies by the one cost of what users feel, and which is best at what.
void add_costs(const Results& results, Document& document);
/// Which policy to use, with the chance of the fit in the interval; only of several fits.
void add_recommendation(const Results& results, Document& document);
/// By which rule the policies got their parameters.
void add_fit(const Results& results, Document& document);
/// In which regime TOCP-DSP helps: payload by payload and channel by channel.
void add_regimes(const Results& results, Document& document);
void add_sensitivity(const Results& results, Document& document);
/// Simulated and real runs of the same seeds.
void add_reality(const Results& results, Document& document);
void add_definitions(const Results& results, Document& document);
void add_settings(const Results& results, Document& document);

/// Sets of one kind.
[[nodiscard]] std::vector<const RunSet*> sets_of(const Results& results, const std::string& kind);
/// "a.thesis.camera": of a round, for names of figures.
[[nodiscard]] std::string round_id(const Group& group);
/// "Mission A, channel thesis, payload camera".
[[nodiscard]] std::string round_title(const Group& group);

}  // namespace tocsin::experiment
