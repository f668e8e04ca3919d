// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "shapes/shape_options.hpp"

namespace tocsin::shapes {

/// Writes shapes, or prints those that come, until `is_over` says so.
void publish(const ShapeOptions& options, const std::function<bool()>& is_over);
void subscribe(const ShapeOptions& options, const std::function<bool()>& is_over);

}  // namespace tocsin::shapes
