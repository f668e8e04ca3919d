// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace tocsin::vda5050 {

/// Of the interface: what a site's fleet manager speaks.
enum class Version : std::uint8_t { v2_1, v3_0 };
constexpr std::array<const char*, 2> words_of(Version) { return {"2.1", "3.0"}; }

/// Whose messages a connection carries.
struct Identity {
  Version version = Version::v3_0;
  std::string interface_name;  ///< first level of the topics; empty: the standard's usual one
  std::string manufacturer;
  std::string serial_number;

  /// The topic of a message, as "vda5050/v3/tocsin/uxv1/order".
  [[nodiscard]] std::string topic(const std::string& message) const;
  /// As a message's `version` has it.
  [[nodiscard]] const char* version_text() const;
};

/// What is wrong with an order, an action or the vehicle. 3.0 has a list of types, section 6.6.5.4;
/// 2.1 has four, section 6.6.4, and leaves the others open.
enum class ErrorType : std::uint8_t {
  validation_failure,
  unsupported_parameter,
  invalid_order_action,
  invalid_instant_action,
  outdated_order_update,
  same_order_update_id,
  order_update_following_cancel,
  no_order_to_cancel,
  other_order_active,
  start_node_out_of_range,
  no_route_to_target,
  mobile_robot_not_available,
  unknown_map_id,
  insufficient_memory,
  instant_action_states_full,
  node_unreachable,
  localization_error,
  hazard_detected,  ///< ours: cliff or wheel drop
};

[[nodiscard]] const char* error_name(ErrorType type, Version version);
/// "WARNING", "URGENT", "CRITICAL" or "FATAL"; of 2.1 "WARNING" or "FATAL".
[[nodiscard]] const char* error_level(ErrorType type, Version version);

/// One entry of `errors`.
struct Fault {
  ErrorType type = ErrorType::validation_failure;
  std::string description;
  std::vector<std::pair<std::string, std::string>> references = {};  ///< key and value
};

inline bool operator==(const Fault& a, const Fault& b) {
  return a.type == b.type && a.description == b.description && a.references == b.references;
}

/// UTC as ISO 8601 with milliseconds: "2026-11-29T12:00:00.000Z". `wall_ns`: since the Unix epoch.
[[nodiscard]] std::string timestamp(std::int64_t wall_ns);

}  // namespace tocsin::vda5050
