// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "decision/policy_params.hpp"
#include "recorded_run.hpp"

namespace tocsin::tools {

/// Some parameters and where they were taken from.
struct ParameterSource {
  std::string name;                                         ///< a file, or an option
  std::vector<std::pair<std::string, std::string>> values;  ///< key and value as written there
};

/// The parameters of a policy. What no source names has its default.
struct PolicySettings {
  decision::PolicyParams params;
  std::vector<ParameterSource> sources;  ///< a later one counts more
};

/// What a program was told about the policy.
struct PolicyRequest {
  std::optional<ControllerParameters> run;  ///< of a recorded run
  std::string model;                        ///< path of a model file (YAML, keys of PolicyParams)
  std::vector<std::string> set;             ///< "key=value"
  std::string policy;                       ///< name of one; empty: as the others say
};

/// Settings by run, model, set and policy, each of which counts more than those before it. Where a
/// key replaces another one (alpha by false_alarm_samples or detector_threshold,
/// good_mean by good_family), the one of the later source holds. Throws ConfigError
/// naming the file or option, key and value.
[[nodiscard]] PolicySettings load_settings(const PolicyRequest& request);

/// Whether a source says which policy decides.
[[nodiscard]] bool names_policy(const PolicySettings& settings);

/// One line for each source, and one for the defaults.
[[nodiscard]] std::string to_text(const PolicySettings& settings);

/// The sources' names, for the error of a rule across parameters.
[[nodiscard]] std::string source_names(const PolicySettings& settings);

}  // namespace tocsin::tools
