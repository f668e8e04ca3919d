// SPDX-License-Identifier: Apache-2.0
#include "telemetry/cpu_load.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "telemetry/words.hpp"

namespace tocsin::telemetry {
namespace {

/// user, nice, system, idle, iowait, irq, softirq, steal (proc(5)).
std::optional<CpuTimes> parse_times(std::string_view words) {
  std::array<std::uint64_t, 8> ticks{};
  for (auto& tick : ticks) {
    const auto number = whole_number<std::uint64_t>(take_word(words));
    if (!number) return std::nullopt;
    tick = *number;
  }
  const auto [user, nice, system, idle, iowait, irq, softirq, steal] = ticks;
  return CpuTimes{user + nice + system + irq + softirq + steal, idle + iowait};
}

/// The number in "cpu12"; empty for anything else.
std::optional<int> core_number(std::string_view word) {
  if (word.substr(0, 3) != "cpu") return std::nullopt;
  const auto number = whole_number<int>(word.substr(3));
  return number && *number >= 0 ? number : std::nullopt;
}

/// Counters may step back a little (iowait does, proc(5)): that is no time.
double growth(std::uint64_t from, std::uint64_t to) {
  return to > from ? static_cast<double>(to - from) : 0.0;
}

std::optional<double> load_percent(const CpuTimes& from, const CpuTimes& to) {
  const double busy = growth(from.busy, to.busy);
  const double all = busy + growth(from.idle, to.idle);
  if (all <= 0) return std::nullopt;
  return 100.0 * busy / all;
}

}  // namespace

std::optional<CpuSnapshot> parse_proc_stat(const std::string& text) {
  std::optional<CpuTimes> all;
  CpuSnapshot snapshot;
  for (std::string_view rest = text; !rest.empty();) {
    std::string_view words = take_line(rest);
    const std::string_view name = take_word(words);
    if (name == "cpu") all = parse_times(words);
    const auto core = core_number(name);
    if (!core) continue;
    if (const auto times = parse_times(words)) snapshot.cores[*core] = *times;
  }
  if (!all) return std::nullopt;
  snapshot.all = *all;
  return snapshot;
}

std::optional<CpuLoad> CpuLoadMeter::update(const CpuSnapshot& snapshot) {
  const std::optional<CpuSnapshot> last = std::exchange(last_, snapshot);
  if (!last) return std::nullopt;
  const auto all = load_percent(last->all, snapshot.all);
  if (!all) return std::nullopt;
  CpuLoad load{*all, {}};
  for (const auto& [number, times] : snapshot.cores) {
    const auto before = last->cores.find(number);
    if (before == last->cores.end()) continue;
    load.cores_percent.push_back(load_percent(before->second, times).value_or(0.0));
  }
  return load;
}

}  // namespace tocsin::telemetry
