// SPDX-License-Identifier: Apache-2.0
#include "vda5050_gateway/protocol.hpp"

#include <fmt/format.h>

#include <ctime>

namespace tocsin::vda5050 {
namespace {

struct ErrorRow {
  const char* name;     // in 3.0
  const char* level;    // in 3.0
  const char* name_21;  // in 2.1
};

/// In the order of ErrorType.
constexpr ErrorRow rows[] = {
    {"VALIDATION_FAILURE", "WARNING", "validationError"},
    {"UNSUPPORTED_PARAMETER", "CRITICAL", "orderError"},
    {"INVALID_ORDER_ACTION", "WARNING", "orderError"},
    {"INVALID_INSTANT_ACTION", "WARNING", "instantActionError"},
    {"OUTDATED_ORDER_UPDATE", "WARNING", "orderUpdateError"},
    {"SAME_ORDER_UPDATE_ID", "WARNING", "orderUpdateError"},
    {"ORDER_UPDATE_FOLLOWING_CANCEL", "WARNING", "orderUpdateError"},
    {"NO_ORDER_TO_CANCEL", "WARNING", "noOrderToCancel"},
    {"OTHER_ORDER_ACTIVE", "WARNING", "orderUpdateError"},
    {"START_NODE_OUT_OF_RANGE", "WARNING", "orderError"},
    {"NO_ROUTE_TO_TARGET", "WARNING", "orderError"},
    {"MOBILE_ROBOT_NOT_AVAILABLE", "WARNING", "orderError"},
    {"UNKNOWN_MAP_ID", "WARNING", "orderError"},
    {"INSUFFICIENT_MEMORY", "URGENT", "orderError"},
    {"INSTANT_ACTION_STATES_FULL", "URGENT", "instantActionError"},
    {"NODE_UNREACHABLE", "CRITICAL", "nodeUnreachable"},
    {"LOCALIZATION_ERROR", "FATAL", "localizationError"},
    {"HAZARD_DETECTED", "FATAL", "hazardDetected"},
};

const ErrorRow& row_of(ErrorType type) { return rows[static_cast<std::size_t>(type)]; }

}  // namespace

std::string Identity::topic(const std::string& message) const {
  const bool is_new = version == Version::v3_0;
  const std::string name = !interface_name.empty() ? interface_name : is_new ? "vda5050" : "uagv";
  return name + (is_new ? "/v3/" : "/v2/") + manufacturer + "/" + serial_number + "/" + message;
}

const char* Identity::version_text() const { return version == Version::v3_0 ? "3.0.0" : "2.1.0"; }

const char* error_name(ErrorType type, Version version) {
  return version == Version::v3_0 ? row_of(type).name : row_of(type).name_21;
}

const char* error_level(ErrorType type, Version version) {
  const char* level = row_of(type).level;
  if (version == Version::v3_0) return level;
  return std::string(level) == "FATAL" ? "FATAL" : "WARNING";
}

std::string timestamp(std::int64_t wall_ns) {
  constexpr std::int64_t second_ns = 1'000'000'000;
  std::int64_t seconds = wall_ns / second_ns;
  if (wall_ns % second_ns < 0) --seconds;
  const auto time = static_cast<std::time_t>(seconds);
  std::tm utc{};
  gmtime_r(&time, &utc);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", utc.tm_year + 1900,
                     utc.tm_mon + 1, utc.tm_mday, utc.tm_hour, utc.tm_min, utc.tm_sec,
                     (wall_ns - seconds * second_ns) / 1'000'000);
}

}  // namespace tocsin::vda5050
