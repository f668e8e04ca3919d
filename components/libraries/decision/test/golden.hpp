// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "foundation/csv_table.hpp"

namespace tocsin::decision {

/// Where the golden numbers lie on a developer's machine; empty when they are absent.
inline std::filesystem::path golden_file(const std::string& name) {
  const char* shared = std::getenv("TOCSIN_SHARED");
  const std::filesystem::path root = shared ? shared : TOCSIN_REPOSITORY "/../shared";
  const auto path = root / "data" / "golden" / name;
  return std::filesystem::exists(path) ? path : std::filesystem::path{};
}

/// A CSV file by column; text that is no number becomes NaN and is kept in `texts`.
struct Table {
  std::map<std::string, std::vector<double>> columns;
  std::map<std::string, std::vector<std::string>> texts;
  std::size_t rows = 0;
};

inline std::vector<std::string> split(const std::string& line) {
  const auto row = CsvReader(line).next();
  return row ? row->cells : std::vector<std::string>{};
}

inline Table read_table(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> names = split(line);
  Table table;
  for (; std::getline(file, line); ++table.rows) {
    const std::vector<std::string> cells = split(line);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::string cell = i < cells.size() ? cells[i] : "";
      char* end = nullptr;
      const double x = std::strtod(cell.c_str(), &end);
      table.columns[names[i]].push_back(end == cell.c_str() ? std::nan("") : x);
      table.texts[names[i]].push_back(cell);
    }
  }
  return table;
}

/// Counts how many numbers are outside a tolerance and keeps the worst.
class Deviations {
 public:
  /// Relative to `want`, absolute below 1.
  void relative(double got, double want, double tolerance) {
    note(std::abs(got - want) / std::max(1.0, std::abs(want)), tolerance);
  }
  /// Relative to `want`, however small it is.
  void strictly_relative(double got, double want, double tolerance) {
    note(want == 0 ? std::abs(got) : std::abs(got - want) / std::abs(want), tolerance);
  }
  void absolute(double got, double want, double tolerance) {
    note(std::abs(got - want), tolerance);
  }
  void exact(long got, long want) { note(got == want ? 0 : 1, 0); }

  [[nodiscard]] int compared() const { return compared_; }
  [[nodiscard]] int outside() const { return outside_; }
  [[nodiscard]] std::string summary() const {
    std::ostringstream text;
    text << compared_ << " compared, " << outside_ << " outside, worst " << worst_;
    return text.str();
  }

 private:
  void note(double deviation, double tolerance) {
    ++compared_;
    if (!(deviation <= tolerance)) ++outside_;
    if (!(deviation <= worst_)) worst_ = deviation;
  }
  int compared_ = 0;
  int outside_ = 0;
  double worst_ = 0;
};

}  // namespace tocsin::decision
