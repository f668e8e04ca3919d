// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "camera/picture.hpp"

namespace tocsin::camera {

/// Baseline JPEG with halved colour resolution. `quality` as in libjpeg, 1 to 100. Empty when
/// memory runs out.
[[nodiscard]] std::vector<std::uint8_t> encode_jpeg(const Picture& picture, int quality);

}  // namespace tocsin::camera
