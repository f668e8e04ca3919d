// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>

namespace tocsin::kobuki {

/// A draw from the normal distribution with mean 0 and deviation 1.
[[nodiscard]] double standard_normal(std::mt19937_64& random);

}  // namespace tocsin::kobuki
