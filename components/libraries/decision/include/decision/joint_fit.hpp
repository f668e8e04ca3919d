// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "decision/cusum.hpp"
#include "decision/joint_index.hpp"

namespace tocsin::decision {

/// A joint index fitted to a good and a bad link.
struct JointFit {
  JointIndexParams params;
  Normal good;       ///< law of the index on the good link: the policy's good_mean and good_sd
  Normal bad;        ///< on the bad ones
  double shrinkage;  ///< of the correlations towards 0, [0,1]
};

/// Centre, scale and correlation from the good link, the falls from the difference to each kind of
/// bad link. What correlated samples say of ten correlations is uncertain, so these are shrunk as
/// Schaefer and Strimmer (2005) do, with the number of samples that their correlation in time
/// leaves. A reading that is told in fewer than 50 samples of the good or of a bad link tells
/// nothing of it. Throws ConfigError when there is a kind of bad link in which no reading is worse.
[[nodiscard]] JointFit fit_joint(const std::vector<JointIndexInput>& good,
                                 const std::vector<std::vector<JointIndexInput>>& bad);

}  // namespace tocsin::decision
