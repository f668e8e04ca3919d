// SPDX-License-Identifier: Apache-2.0
#include "measure.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

namespace tocsin::bench {

std::int64_t now_ns() { return std::chrono::steady_clock::now().time_since_epoch().count(); }

double Series::percentile(double share) const {
  if (values_.empty()) return 0;
  std::vector<std::int64_t> sorted = values_;
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), sorted.begin() + at, sorted.end());
  return static_cast<double>(sorted[static_cast<std::size_t>(at)]);
}

int Series::above(std::int64_t ns) const {
  return static_cast<int>(
      std::count_if(values_.begin(), values_.end(), [ns](std::int64_t one) { return one > ns; }));
}

std::string Series::text() const {
  if (empty()) return "no samples";
  std::array<char, 64> text{};
  (void)std::snprintf(text.data(), text.size(), "%9.2f / %9.2f", percentile(0.5) / 1000,
                      percentile(0.99) / 1000);
  return text.data();
}

std::string share_text(std::vector<double> shares) {
  if (shares.empty()) return "none";
  std::sort(shares.begin(), shares.end());
  const auto n = static_cast<double>(shares.size());
  const double half = 0.98 * std::sqrt(n);  // 1.96 standard deviations of a binomial of 1/2
  const auto at = [&](double rank) {
    return shares[static_cast<std::size_t>(std::clamp(rank, 0.0, n - 1))];
  };
  std::array<char, 64> text{};
  (void)std::snprintf(text.data(), text.size(), "%.3g [%.3g, %.3g]", at(std::floor(n / 2)),
                      at(std::floor(n / 2 - half)), at(std::ceil(n / 2 + half)));
  return text.data();
}

long proc_number(const std::string& file, const std::string& key) {
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line)) {
    if (line.compare(0, key.size() + 1, key + ":") != 0) continue;
    std::istringstream rest(line.substr(key.size() + 1));
    long value = 0;
    rest >> value;
    return value;
  }
  return 0;
}

double cpu_s(int process) {
  std::ostringstream text;
  text << std::ifstream("/proc/" + std::to_string(process) + "/stat").rdbuf();
  std::istringstream words(text.str().substr(text.str().rfind(')') + 1));
  std::string word;
  for (int field = 3; field < 14; ++field) words >> word;
  double user = 0;
  double system = 0;
  words >> user >> system;  // proc(5): fields 14 and 15
  return (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

std::string output_of(const std::string& command) {
  std::string text;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return text;
  std::array<char, 512> buffer{};
  while (fgets(buffer.data(), buffer.size(), pipe) != nullptr) text += buffer.data();
  pclose(pipe);
  return text;
}

}  // namespace tocsin::bench
