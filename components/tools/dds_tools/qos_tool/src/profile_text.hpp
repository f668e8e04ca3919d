// SPDX-License-Identifier: Apache-2.0
// Profiles as a person or a script reads them: list, show, explain, diff.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "runtime/middleware/qos_profile.hpp"

namespace tocsin::qos_tool {

/// Who uses a profile.
struct TopicUse {
  std::string topic;
  std::string profile;
  bool crosses_link = false;
};

/// Of all libraries of messages that are installed.
[[nodiscard]] std::vector<TopicUse> known_uses();

/// The profile of this name. Throws ConfigError, with what is like it, when there is none.
[[nodiscard]] const QosProfile& find_profile(const QosProfiles& profiles, const std::string& name);

/// Each profile with its gist and its topics.
[[nodiscard]] std::string list_text(const QosProfiles& profiles, const std::vector<TopicUse>& uses);
[[nodiscard]] nlohmann::json list_json(const QosProfiles& profiles,
                                       const std::vector<TopicUse>& uses);

/// What differs from the defaults as a line of a QoS file; `all`: every policy, a line each.
[[nodiscard]] std::string show_text(const std::string& name, const QosProfile& profile, bool all);
[[nodiscard]] nlohmann::json show_json(const std::string& name, const QosProfile& profile);

/// Every policy with its value and what it means.
[[nodiscard]] std::string explain_text(const std::string& name, const QosProfile& profile,
                                       const std::vector<TopicUse>& uses);

/// The policies by which they differ, with what each has.
[[nodiscard]] std::string diff_text(const QosProfile& one, const QosProfile& other);
[[nodiscard]] nlohmann::json diff_json(const QosProfile& one, const QosProfile& other);

}  // namespace tocsin::qos_tool
