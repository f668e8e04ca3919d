// SPDX-License-Identifier: Apache-2.0
#include "link_map/signal_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "foundation/csv_table.hpp"
#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/numbers.hpp"
#include "foundation/printable.hpp"

namespace tocsin::link_map {
namespace {

using Words = std::vector<std::string>;

constexpr const char* blank = " \t\r";

/// Of the x, the y and the signal.
const std::array<Words, 3> usual_names{
    Words{"x_m", "x", "pose_x", "pos_x", "position_x", "robot_pos_x"},
    Words{"y_m", "y", "pose_y", "pos_y", "position_y", "robot_pos_y"},
    Words{"signal_dbm", "rssi_dbm", "rssi", "signal", "dbm", "C_level_a"}};
constexpr const char* loss_name = "loss_percent";  // need not be there

Words split(std::string_view line, char separator) {
  Words words;
  while (true) {
    if (separator == ' ') line.remove_prefix(std::min(line.find_first_not_of(blank), line.size()));
    if (separator == ' ' && line.empty()) return words;
    const std::size_t end = separator == ' ' ? line.find_first_of(blank) : line.find(separator);
    std::string word(line.substr(0, end));
    word.erase(0, std::min(word.find_first_not_of(blank), word.size()));
    word.erase(word.find_last_not_of(blank) + 1);
    words.push_back(std::move(word));
    if (end == std::string_view::npos) return words;
    line.remove_prefix(end + 1);
  }
}

char separator_of(std::string_view header) {
  for (const char separator : {',', ';'}) {
    if (header.find(separator) != std::string_view::npos) return separator;
  }
  return ' ';
}

std::optional<std::size_t> find(const Words& words, const Words& names) {
  for (const std::string& name : names) {
    const auto found = std::find(words.begin(), words.end(), name);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  }
  return std::nullopt;
}

std::array<std::size_t, 3> places_of(const Words& header, const std::string& name,
                                     const std::string& columns) {
  std::array<Words, 3> wanted = usual_names;
  if (!columns.empty()) {
    const Words names = split(columns, ',');
    if (names.size() != wanted.size()) {
      throw ConfigError("--columns: '" + printable(columns) + "' is not X,Y,SIGNAL");
    }
    for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i] = {names[i]};
  }
  std::array<std::size_t, 3> places{};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const auto found = find(header, wanted[i]);
    if (!found) {
      throw ConfigError(
          fmt::format("{}: line 1 names no column {}; --columns X,Y,SIGNAL chooses of: {}", name,
                      joined(wanted[i], " or "), printable(joined(header))));
    }
    places[i] = *found;
  }
  return places;
}

/// NaN: empty, or said to be none.
double number_in(const std::string& cell, const std::string& column, const std::string& name,
                 std::size_t line) {
  const double value = csv_number(cell);
  const bool is_none = cell.empty() || cell == "nan" || cell == "NaN" || cell == "NA";
  if (!std::isnan(value) || is_none) return value;
  throw ConfigError(
      fmt::format("{}:{}: {}: '{}' is no number", name, line, printable(column), printable(cell)));
}

/// NaN: not told.
double lost_share_in(const Words& cells, const Words& header, const std::string& name,
                     std::size_t line) {
  const auto place = find(header, {loss_name});
  if (!place || *place >= cells.size()) return nan;
  return number_in(cells[*place], loss_name, name, line) / 100;
}

}  // namespace

std::vector<Reading> signals_in(std::string_view text, const std::string& name,
                                const std::string& columns) {
  std::vector<Reading> readings;
  Words header;
  std::array<std::size_t, 3> places{};
  char separator = ' ';
  for (std::size_t line = 1; !text.empty(); ++line) {
    const std::size_t end = text.find('\n');
    const std::string_view one = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    if (header.empty()) {
      separator = separator_of(one);
      header = split(one, separator);
      places = places_of(header, name, columns);
      continue;
    }
    const Words cells = split(one, separator);
    if (cells.empty() || (cells.size() == 1 && cells[0].empty())) continue;
    std::array<double, 3> values{};
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (places[i] >= cells.size()) {
        throw ConfigError(fmt::format("{}:{}: has {} columns, but {} is the {}th", name, line,
                                      cells.size(), printable(header[places[i]]), places[i] + 1));
      }
      values[i] = number_in(cells[places[i]], header[places[i]], name, line);
    }
    readings.push_back(
        {{values[0], values[1]}, values[2], lost_share_in(cells, header, name, line)});
  }
  if (header.empty()) throw ConfigError(name + ": is empty");
  return readings;
}

std::string signal_text(const std::vector<Reading>& readings) {
  std::string text = fmt::format("x_m,y_m,signal_dbm,{}\n", loss_name);
  for (const Reading& reading : readings) {
    const std::string lost =
        std::isnan(reading.lost_share) ? "" : fmt::format("{:.0f}", 100 * reading.lost_share);
    text += fmt::format("{:.2f},{:.2f},{:.1f},{}\n", reading.at.x_m, reading.at.y_m,
                        reading.signal_dbm, lost);
  }
  return text;
}

}  // namespace tocsin::link_map
