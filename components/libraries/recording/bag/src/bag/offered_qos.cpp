// SPDX-License-Identifier: Apache-2.0
#include "bag/offered_qos.hpp"

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>

#include "foundation/error.hpp"
#include "foundation/time.hpp"
#include "foundation/yaml_sources.hpp"
#include "scalar_at.hpp"

namespace tocsin::bag {
namespace {

constexpr std::int64_t ns_per_s = 1'000'000'000;
// RMW_DURATION_INFINITE: the most nanoseconds that 64 bits hold.
constexpr std::int64_t infinite_s = 9'223'372'036;
constexpr std::int64_t infinite_ns = 854'775'807;

// Words of Jazzy and later, by their numbers; Iron and earlier write the numbers.
constexpr std::array history_words{"system_default", "keep_last", "keep_all", "unknown"};
constexpr std::array reliability_words{"system_default", "reliable", "best_effort", "unknown"};
constexpr std::array durability_words{"system_default", "transient_local", "volatile", "unknown"};
constexpr std::array liveliness_words{"system_default", "automatic", "manual_by_node",
                                      "manual_by_topic", "unknown"};

std::string duration_text(const char* name, const std::optional<std::int64_t>& ns) {
  return fmt::format("  {}:\n    sec: {}\n    nsec: {}\n", name, ns ? *ns / ns_per_s : infinite_s,
                     ns ? *ns % ns_per_s : infinite_ns);
}

std::optional<std::int64_t> number(const std::string& text) {
  if (text.empty() || text.size() > 19) return std::nullopt;
  const bool digits =
      std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!digits) return std::nullopt;
  return static_cast<std::int64_t>(std::stoull(text));
}

template <class Enum, std::size_t N>
void read_enum(const YAML::Node& map, const char* key, const std::array<const char*, N>& words,
               Enum& value) {
  const std::string text = scalar_at(map, key);
  const auto found = std::find(words.begin(), words.end(), text);
  const auto place =
      found != words.end() ? std::optional<std::int64_t>(found - words.begin()) : number(text);
  if (place && *place < static_cast<std::int64_t>(N)) value = static_cast<Enum>(*place);
}

std::optional<std::int64_t> read_duration(const YAML::Node& map, const char* key) {
  const YAML::Node node = map[key];
  if (!node.IsDefined() || !node.IsMap()) return std::nullopt;
  const auto s = number(scalar_at(node, "sec"));
  const auto ns = number(scalar_at(node, "nsec"));
  // A duration of nothing is what some releases write for "not said".
  if (!s || !ns || *s >= infinite_s || *ns >= ns_per_s || (*s == 0 && *ns == 0)) {
    return std::nullopt;
  }
  return *s * ns_per_s + *ns;
}

OfferedQos read_one(const YAML::Node& map) {
  OfferedQos one;
  read_enum(map, "history", history_words, one.history);
  read_enum(map, "reliability", reliability_words, one.reliability);
  read_enum(map, "durability", durability_words, one.durability);
  read_enum(map, "liveliness", liveliness_words, one.liveliness);
  constexpr std::int64_t most_depth = 1'000'000;
  one.depth = static_cast<int>(std::min(number(scalar_at(map, "depth")).value_or(0), most_depth));
  one.deadline_ns = read_duration(map, "deadline");
  one.lifespan_ns = read_duration(map, "lifespan");
  one.liveliness_lease_ns = read_duration(map, "liveliness_lease_duration");
  return one;
}

}  // namespace

std::optional<std::int64_t> finite_ns(double s) {
  constexpr double longest_s = 9e9;
  if (!(s < longest_s)) return std::nullopt;
  return seconds(s).count();
}

std::string to_yaml(const std::vector<OfferedQos>& offered) {
  std::string text;
  for (const OfferedQos& one : offered) {
    text += fmt::format("- history: {}\n  depth: {}\n  reliability: {}\n  durability: {}\n",
                        static_cast<int>(one.history), one.depth, static_cast<int>(one.reliability),
                        static_cast<int>(one.durability));
    text += duration_text("deadline", one.deadline_ns);
    text += duration_text("lifespan", one.lifespan_ns);
    text += fmt::format("  liveliness: {}\n", static_cast<int>(one.liveliness));
    text += duration_text("liveliness_lease_duration", one.liveliness_lease_ns);
    text += "  avoid_ros_namespace_conventions: false\n";
  }
  if (!text.empty()) text.pop_back();
  return text;
}

std::vector<OfferedQos> parse_offered_qos(const std::string& text) {
  std::vector<OfferedQos> offered;
  YAML::Node list;
  try {
    YamlSources sources;
    list = sources.parse(text, "offered_qos_profiles");
  } catch (const ConfigError&) {
    return {};
  }
  if (!list.IsSequence()) return {};
  for (const YAML::Node& one : list) {
    if (one.IsMap()) offered.push_back(read_one(one));
  }
  return offered;
}

}  // namespace tocsin::bag
