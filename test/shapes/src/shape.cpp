// SPDX-License-Identifier: Apache-2.0
#include "shapes/shape.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <random>
#include <sstream>

#include "foundation/error.hpp"

namespace tocsin::shapes {
namespace {

constexpr int width = 240;
constexpr int height = 270;
constexpr int fastest = 5;

/// One coordinate and its velocity, which turns at the walls.
void move(int& place, int& velocity, int wall) {
  place += velocity;
  if (place >= 0 && place <= wall) return;
  place = std::clamp(place, 0, wall);
  velocity = -velocity;
}

template <class Value>
bool compare(const Value& left, const std::string& relation, const Value& right) {
  if (relation == "=") return left == right;
  if (relation == "<>") return left != right;
  if (relation == "<") return left < right;
  if (relation == "<=") return left <= right;
  return relation == ">" ? left > right : left >= right;
}

}  // namespace

ShapeMotion::ShapeMotion(const ShapeOptions& options, unsigned seed) : options_(options) {
  std::minstd_rand random(seed);
  const auto velocity = [&random] {
    const int speed = 1 + static_cast<int>(random() % fastest);
    return random() % 2 == 0 ? speed : -speed;
  };
  shape_.x = static_cast<int>(random() % width);
  shape_.y = static_cast<int>(random() % height);
  dx_ = velocity();
  dy_ = velocity();
  shape_.size = options.shapesize;
  shape_.payload.assign(static_cast<std::size_t>(options.payload_bytes), 255);
}

std::vector<Shape> ShapeMotion::next() {
  move(shape_.x, dx_, width);
  move(shape_.y, dy_, height);
  if (options_.shapesize == 0) {
    if (options_.size_modulo > 0) shape_.size %= options_.size_modulo;
    ++shape_.size;
  }
  std::vector<Shape> round;
  for (int i = 0; i < options_.instances; ++i) {
    shape_.color = numbered(options_.color, i);
    round.push_back(shape_);
  }
  return round;
}

std::string numbered(const std::string& name, int number) {
  return number == 0 ? name : name + std::to_string(number);
}

std::string sample_line(const std::string& topic, const Shape& shape) {
  const std::string payload =
      shape.payload.empty() ? "" : fmt::format(" {{{}}}", shape.payload.back());
  return fmt::format("{:<10} {:<10} {:03} {:03} [{}]{}", topic, shape.color, shape.x, shape.y,
                     shape.size, payload);
}

std::string stamps_text(std::int64_t stamp_ns, std::int64_t read_ns) {
  return fmt::format(" @{} {}", stamp_ns, read_ns);
}

std::string instance_line(const std::string& topic, const std::string& color, const char* state) {
  return fmt::format("{:<10} {:<10} {}", topic, color, state);
}

ShapeFilter::ShapeFilter(const std::string& expression) {
  std::istringstream words(expression);
  words >> field_ >> operator_;
  std::getline(words >> std::ws, text_);
  const auto is_one_of = [](const std::string& word, const auto& allowed) {
    return std::find(allowed.begin(), allowed.end(), word) != allowed.end();
  };
  constexpr std::array fields{"color", "x", "y", "shapesize"};
  constexpr std::array operators{"=", "<>", "<", "<=", ">", ">="};
  bool valid = is_one_of(field_, fields) && is_one_of(operator_, operators);
  if (field_ == "color") {
    valid = valid && text_.size() >= 2 && text_.front() == '\'' && text_.back() == '\'';
    if (valid) text_ = text_.substr(1, text_.size() - 2);
  } else {
    const auto end = text_.data() + text_.size();
    valid = valid && std::from_chars(text_.data(), end, number_).ptr == end && !text_.empty();
  }
  if (!valid) {
    throw ConfigError("failed to create content filtered topic: '" + expression +
                      "' is not of the form FIELD OPERATOR VALUE");
  }
}

ShapeFilter ShapeFilter::of(const ShapeOptions& options) {
  if (!options.filter.empty()) return ShapeFilter(options.filter);
  ShapeFilter filter;
  if (options.color.empty()) return filter;
  filter.field_ = "color";
  filter.operator_ = "=";
  filter.text_ = options.color;
  return filter;
}

bool ShapeFilter::passes(const Shape& shape) const {
  if (field_.empty()) return true;
  if (field_ == "color") return compare(shape.color, operator_, text_);
  const int value = field_ == "x" ? shape.x : field_ == "y" ? shape.y : shape.size;
  return compare(static_cast<double>(value), operator_, number_);
}

}  // namespace tocsin::shapes
