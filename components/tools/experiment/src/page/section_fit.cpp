// SPDX-License-Identifier: Apache-2.0
// Where the policies' parameters come from.
#include "page/sections.hpp"

namespace tocsin::experiment {

void add_fit(const Results& results, Document& document) {
  document.heading(2, "How the policies got their parameters");
  if (results.fitted.empty()) {
    document.paragraph(
        "No file of fitted parameters: each policy has its defaults or what the experiment file "
        "sets.");
    return;
  }
  document.paragraph(
      "By one rule for all, with <code>tocsin experiment fit</code>, on runs without a policy "
      "whose seeds are not among those compared here. The laws of QNI on a good and on a poor "
      "link are normals by maximum likelihood, the mean lengths of both states are counted; all "
      "policies that use laws share them. Then each policy's own two numbers (threshold: both "
      "levels; TOCP: alpha and length of the pause; TOCP-DSP: alpha and discount; tocp_reverse: "
      "both alphas) are those of a grid of 100 (threshold: 399) pairs that have the least cost "
      "per slot, by the cost above, when the recorded samples are decided again. The belief "
      "policy has no numbers besides laws and lengths, legacy and no policy have none. Silence "
      "does not change a recorded sample, as it changes a real link a little. The parameters "
      "minimise this cost, not the latency and PER that the thesis is judged by.");
  std::vector<std::vector<std::string>> rows{{"mission", "policy", "parameters"}};
  for (const auto& [mission, policies] : results.fitted) {
    for (const auto& [policy, settings] : policies) {
      std::string text;
      for (const std::string& setting : settings) text += (text.empty() ? "" : " ") + setting;
      rows.push_back({html::escape(mission), html::escape(policy), html::escape(text)});
    }
  }
  document.table(rows);
}

}  // namespace tocsin::experiment
