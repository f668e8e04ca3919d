// SPDX-License-Identifier: Apache-2.0
#include "backfill/rule_requests.hpp"

#include <cstdint>
#include <sstream>

#include "wire_names.hpp"

namespace tocsin {
namespace {

/// [ns] since the Unix epoch, either way: far beyond any time that is meant.
constexpr std::int64_t farthest = std::int64_t{1} << 62U;

bool is_sound(const router::RuleRequest& request) {
  const auto& range = request.range;
  const bool is_time = -farthest < range.from_ns && range.to_ns < farthest;
  return is_time && range.from_ns <= range.to_ns && is_wire_name(range.topic, "_/");
}

}  // namespace

std::string to_text(const std::vector<router::RuleRequest>& requests) {
  std::ostringstream text;
  for (const router::RuleRequest& one : requests) {
    text << one.range.id << ' ' << one.range.from_ns << ' ' << one.range.to_ns << ' ' << one.rule
         << ' ' << one.range.topic << '\n';
  }
  return text.str();
}

std::vector<router::RuleRequest> rule_requests_in(const std::string& text) {
  std::vector<router::RuleRequest> requests;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    router::RuleRequest one;
    words >> one.range.id >> one.range.from_ns >> one.range.to_ns >> one.rule >> one.range.topic;
    if (words && is_sound(one)) requests.push_back(std::move(one));
  }
  return requests;
}

}  // namespace tocsin
