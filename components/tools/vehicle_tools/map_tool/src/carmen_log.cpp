// SPDX-License-Identifier: Apache-2.0
#include "carmen_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

#include "foundation/error.hpp"

namespace tocsin::map_tool {
namespace {

using geometry::Pose;

constexpr double most_readings = 100'000;
constexpr double farthest_m = 1e6;
constexpr double farthest_jump_m = 100;
constexpr double latest_s = 1e12;
constexpr double largest_angle_rad = 1000;  // headings that were never wrapped grow

struct Range {
  double low;
  double high;
};

/// Takes the fields off one line.
class Fields {
 public:
  Fields(std::string_view line, const std::string& place) : rest_(line), place_(place) {}

  std::string_view word() {
    const auto begin = rest_.find_first_not_of(" \t\r");
    rest_.remove_prefix(begin == std::string_view::npos ? rest_.size() : begin);
    const auto end = std::min(rest_.find_first_of(" \t\r"), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return word;
  }

  double number(const char* name, Range range) {
    const std::string_view text = word();
    if (text.empty()) fail(fmt::format("{}: is missing, the line ends before it", name));
    double value = nan;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size()) {
      fail(fmt::format("{}: '{}' is no number", name, text));
    }
    if (!(value >= range.low && value <= range.high)) {
      fail(fmt::format("{}: {} is outside [{:g}, {:g}]", name, text, range.low, range.high));
    }
    return value;
  }

  std::size_t count(const char* name, double least) {
    const double value = number(name, {least, most_readings});
    if (value != std::floor(value)) fail(fmt::format("{}: {} is no whole number", name, value));
    return static_cast<std::size_t>(value);
  }

  Pose pose(const char* name) {
    const double x_m = number(name, {-farthest_m, farthest_m});
    const double y_m = number(name, {-farthest_m, farthest_m});
    const double heading_rad = number(name, {-largest_angle_rad, largest_angle_rad});
    return {x_m, y_m, geometry::wrap_angle(heading_rad)};
  }

  std::vector<double> ranges(std::size_t count) {
    std::vector<double> values;
    values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) values.push_back(number("range", {0, farthest_m}));
    return values;
  }

  void skip(const char* name, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) (void)number(name, {-infinity, infinity});
  }

  double time() { return number("time", {0, latest_s}); }

  [[noreturn]] void fail(const std::string& what) const { throw ConfigError(place_ + what); }

 private:
  std::string_view rest_;
  const std::string& place_;
};

LogReading odometry_of(Fields& fields) {
  LogReading reading;
  reading.odometry = fields.pose("pose");
  fields.skip("speed", 3);
  reading.time_s = fields.time();
  return reading;
}

LogReading front_laser_of(Fields& fields) {
  LogReading reading;
  LogScan scan;
  const std::size_t count = fields.count("number of readings", 2);
  scan.ranges_m = fields.ranges(count);
  (void)fields.pose("laser pose");  // as some program corrected it
  reading.odometry = fields.pose("odometry pose");
  reading.time_s = fields.time();
  scan.beams.first_rad = -pi / 2;
  scan.beams.increment_rad = pi / static_cast<double>(count % 2 == 1 ? count - 1 : count);
  reading.scan = std::move(scan);
  return reading;
}

LogReading robot_laser_of(Fields& fields) {
  LogReading reading;
  LogScan scan;
  fields.skip("laser type", 1);
  scan.beams.first_rad = fields.number("start angle", {-2 * pi, 2 * pi});
  (void)fields.number("field of view", {0, 2 * pi + 0.1});
  scan.beams.increment_rad = fields.number("angular resolution", {1e-4, pi});
  scan.max_range_m = fields.number("maximum range", {0.1, farthest_m});
  fields.skip("accuracy", 1);
  fields.skip("remission mode", 1);
  scan.ranges_m = fields.ranges(fields.count("number of readings", 1));
  fields.skip("remission", fields.count("number of remissions", 0));
  const Pose laser = fields.pose("laser pose");
  reading.odometry = fields.pose("robot pose");
  scan.beams.laser = relative(reading.odometry, laser);
  fields.skip("speed, distance or turn axis", 5);
  reading.time_s = fields.time();
  reading.scan = std::move(scan);
  return reading;
}

bool is_keyword(std::string_view word) {
  return std::all_of(word.begin(), word.end(), [](unsigned char c) {
    return std::isupper(c) != 0 || std::isdigit(c) != 0 || c == '_';
  });
}

std::optional<LogReading> reading_of(std::string_view line, const std::string& place) {
  Fields fields(line, place);
  const std::string_view keyword = fields.word();
  if (keyword.empty() || keyword.front() == '#') return std::nullopt;
  if (keyword == "ODOM") return odometry_of(fields);
  if (keyword == "FLASER") return front_laser_of(fields);
  if (keyword == "ROBOTLASER1") return robot_laser_of(fields);
  if (is_keyword(keyword)) return std::nullopt;
  fields.fail(
      fmt::format("'{}' is no message of CARMEN: those are capital letters (ODOM, FLASER, "
                  "ROBOTLASER1, others are passed over)",
                  keyword.substr(0, 40)));
}

}  // namespace

CarmenLog::CarmenLog(std::string_view text, std::string name)
    : text_(text), name_(std::move(name)) {}

std::optional<LogReading> CarmenLog::next() {
  while (!text_.empty()) {
    ++line_;
    const auto end = std::min(text_.find('\n'), text_.size());
    const std::string_view line = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    const std::string place = fmt::format("{}:{}: ", name_, line_);
    auto reading = reading_of(line, place);
    if (!reading) continue;
    const auto here = position(reading->odometry);
    const double jump_m = last_ ? geometry::distance(*last_, here) : 0;
    if (jump_m > farthest_jump_m) {
      throw ConfigError(
          fmt::format("{}odometry: jumps by {:g} m from the reading before it; {:g} m are allowed",
                      place, jump_m, farthest_jump_m));
    }
    last_ = here;
    return reading;
  }
  return std::nullopt;
}

}  // namespace tocsin::map_tool
