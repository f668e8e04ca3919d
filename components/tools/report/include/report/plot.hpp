// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "report/recording.hpp"

namespace tocsin::report {

/// QNI, PER, the pauses, the link and the traffic of each class over time, as draw() takes it.
[[nodiscard]] std::string plot_of(const Recording& recording);

/// Draws it into `plot.png` and `plot.svg` in the run's folder. Throws as draw() does.
void draw_plot(const Recording& recording);

}  // namespace tocsin::report
