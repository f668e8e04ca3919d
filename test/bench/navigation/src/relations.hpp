// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/pose.hpp"

namespace tocsin::bench {

/// Errors of a trajectory by relative poses that people verified (Kuemmerle et al., Autonomous
/// Robots 27(4), 2009).
struct RelationErrors {
  std::size_t count = 0;
  std::size_t missing = 0;  ///< relations at times that the trajectory does not have
  double mean_m = 0;
  double deviation_m = 0;
  double worst_m = 0;
  double mean_deg = 0;
};

/// `trajectory` has lines `time x y theta`, `relations` lines `t1 t2 x y z roll pitch yaw`. With
/// `loops_only` relations of less than 30 s count as missing.
[[nodiscard]] RelationErrors relation_errors(const std::string& trajectory,
                                             const std::string& relations, bool loops_only);

}  // namespace tocsin::bench
