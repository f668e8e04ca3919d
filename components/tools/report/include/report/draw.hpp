// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace tocsin::report {

/// Draws `<prefix>.png` and `<prefix>.svg` of a picture as the program draw_panels takes it (JSON).
/// Blocks for a second or two. Throws EnvironmentError with what it said, or that Python or its
/// matplotlib is not there.
void draw(const std::string& picture, const std::string& prefix);

}  // namespace tocsin::report
