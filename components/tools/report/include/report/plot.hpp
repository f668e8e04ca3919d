// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "report/recording.hpp"

namespace tocsin::report {

/// Draws QNI, PER, the pauses and the traffic of each class over time into `plot.png` and
/// `plot.svg` in the run's folder; data and script stay in `plot/`. Throws EnvironmentError when
/// gnuplot is not there or fails.
void draw_plot(const Recording& recording);

}  // namespace tocsin::report
