// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "foundation/yaml_sources.hpp"
#include "runtime/middleware/traffic_rules.hpp"

namespace tocsin {

/// The list `fetch` of a role; none: it has none. `rules`: those of the role. Throws ConfigError
/// with its place for a rule that says too little or too much, and for topics that are not logged.
[[nodiscard]] std::vector<FetchRule> fetch_rules(const YAML::Node& list, const std::string& role,
                                                 const NameRules<TrafficRule>& rules,
                                                 const YamlSources& sources);

}  // namespace tocsin
