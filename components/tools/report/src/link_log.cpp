// SPDX-License-Identifier: Apache-2.0
#include "report/link_log.hpp"

#include <sys/stat.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

namespace tocsin::report {
namespace {

using Json = nlohmann::json;

double number(const Json& line, const char* key) {
  const auto found = line.find(key);
  return found != line.end() && found->is_number() ? found->get<double>() : std::nan("");
}

double of_both(const Json& line, const char* key) {
  double sum = 0;
  for (const char* direction : {"uplink", "downlink"}) {
    const auto found = line.find(direction);
    sum += found != line.end() && found->is_object() ? number(*found, key) : std::nan("");
  }
  return sum;
}

std::optional<LinkState> parse(const std::string& text) {
  const Json line = Json::parse(text, nullptr, false);
  if (!line.is_object() || !std::isfinite(number(line, "elapsed_s"))) return std::nullopt;
  return LinkState{number(line, "elapsed_s"),     number(line, "mean_snr_db"),
                   number(line, "busy_share"),    of_both(line, "airtime_s"),
                   of_both(line, "bytes_pushed"), number(line, "late_ms")};
}

double changed_at_s(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return 0;
  return static_cast<double>(status.st_mtim.tv_sec) +
         1e-9 * static_cast<double>(status.st_mtim.tv_nsec);
}

}  // namespace

std::vector<LinkState> read_link_log(const std::string& path) {
  std::vector<LinkState> states;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);) {
    if (const auto state = parse(line)) states.push_back(*state);
  }
  if (states.empty()) return states;
  const double start_s = changed_at_s(path) - states.back().time_s;
  for (LinkState& state : states) state.time_s += start_s;
  return states;
}

}  // namespace tocsin::report
