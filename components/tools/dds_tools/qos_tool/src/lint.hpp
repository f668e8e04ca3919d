// SPDX-License-Identifier: Apache-2.0
// Known traps of QoS profiles, each with its reason.
#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "foundation/traffic_class.hpp"
#include "runtime/middleware/qos_profile.hpp"

namespace tocsin::qos_tool {

/// How a topic goes from its writers to its readers.
enum class Way {
  host,    ///< stays on one computer
  routed,  ///< crosses the radio by link_router, which repairs, and compares no clocks
  direct,  ///< its ends stand on the radio themselves
};

/// A topic as a lint sees it.
struct LintTopic {
  std::string name;
  std::string profile;
  Way way = Way::host;
  bool is_stream = false;  ///< large, frequent, follows the link's budget: `adaptive`
  TrafficClass traffic_class = TrafficClass::normal;
};

struct LintInput {
  std::map<std::string, QosProfile> profiles;
  std::vector<LintTopic> topics;
  double outage_s = 10;        ///< [s] the radio is away so long now and then
  double clock_offset_s = 60;  ///< [s] the clocks of two computers may differ so much
};

/// One trap that something is in.
struct Finding {
  std::string rule;     ///< its name, for scripts
  std::string subject;  ///< profile or topic
  std::string reason;
};

/// Marks the topics of these profiles as streams. One that no topic has is judged as if its ends
/// stood on the radio. Throws ConfigError for an unknown one; `file` says where they are.
void mark_streams(LintInput& input, const std::vector<std::string>& profiles,
                  const std::string& file);

/// In the order of the rules; empty: no known trap.
[[nodiscard]] std::vector<Finding> lint(const LintInput& input);

[[nodiscard]] std::string lint_text(const std::vector<Finding>& findings);
[[nodiscard]] nlohmann::json lint_json(const std::vector<Finding>& findings);

}  // namespace tocsin::qos_tool
