// SPDX-License-Identifier: Apache-2.0
// Shapes that move, and what is said of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shapes/shape_options.hpp"

namespace tocsin::shapes {

/// One sample, without a vendor's type.
struct Shape {
  std::string color;
  int x = 0;
  int y = 0;
  int size = 0;
  std::vector<std::uint8_t> payload;
};

/// What a publisher writes: one shape a round, in each colour. Pure.
class ShapeMotion {
 public:
  /// `seed` draws place and velocity.
  ShapeMotion(const ShapeOptions& options, unsigned seed);
  /// The samples of the next round, one of each instance.
  [[nodiscard]] std::vector<Shape> next();

 private:
  const ShapeOptions options_;
  Shape shape_;
  int dx_;
  int dy_;
};

/// Colour of an instance: BLUE, BLUE1, BLUE2. Name of a topic: Square, Square1.
[[nodiscard]] std::string numbered(const std::string& name, int number);

/// A line of shape_main: `Square     BLUE       012 034 [20]`.
[[nodiscard]] std::string sample_line(const std::string& topic, const Shape& shape);
/// What follows a line with --stamps: the instant that lifespan and separation count from, and that
/// of the read, both in [ns] of the subscriber's clock.
[[nodiscard]] std::string stamps_text(std::int64_t stamp_ns, std::int64_t read_ns);
/// `Square     BLUE       NOT_ALIVE_DISPOSED_INSTANCE_STATE`; `state` is the last word.
[[nodiscard]] std::string instance_line(const std::string& topic, const std::string& color,
                                        const char* state);

/// A content filter of the form `FIELD OPERATOR VALUE`: fields color, x, y and shapesize, operators
/// = <> < <= > >=, a number or a text in single quotes. Pure.
class ShapeFilter {
 public:
  /// Passes everything.
  ShapeFilter() = default;
  /// Throws ConfigError for what is not of that form.
  explicit ShapeFilter(const std::string& expression);
  /// What a subscriber asks for by --cft, else by -c, else everything.
  [[nodiscard]] static ShapeFilter of(const ShapeOptions& options);
  [[nodiscard]] bool passes(const Shape& shape) const;

 private:
  std::string field_;
  std::string operator_;
  std::string text_;
  double number_ = 0;
};

}  // namespace tocsin::shapes
