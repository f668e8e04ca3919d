// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tocsin::bag {

/// What a writer offered, as a bag tells it: numbers and fields of rmw_qos_profile_t of ROS 2.
struct OfferedQos {
  enum class History { system_default, keep_last, keep_all, unknown };
  enum class Reliability { system_default, reliable, best_effort, unknown };
  enum class Durability { system_default, transient_local, volatile_kind, unknown };
  enum class Liveliness { system_default, automatic, manual_by_node, manual_by_topic, unknown };

  History history = History::unknown;  ///< it is not on the wire
  int depth = 0;
  Reliability reliability = Reliability::reliable;
  Durability durability = Durability::volatile_kind;
  std::optional<std::int64_t> deadline_ns;  ///< empty: infinite
  std::optional<std::int64_t> lifespan_ns;
  Liveliness liveliness = Liveliness::automatic;
  std::optional<std::int64_t> liveliness_lease_ns;
};

/// [ns] A duration of a QoS policy; empty when it is infinite, which it is from 9e9 s on.
[[nodiscard]] std::optional<std::int64_t> finite_ns(double s);

/// The text of `offered_qos_profiles`: a YAML list, with numbers, which all releases of ROS 2 read.
[[nodiscard]] std::string to_yaml(const std::vector<OfferedQos>& offered);

/// What such a text says, of releases with numbers or with words. What it does not say, or says in
/// an unknown way, has its default; a text that is no list of maps says nothing.
[[nodiscard]] std::vector<OfferedQos> parse_offered_qos(const std::string& text);

}  // namespace tocsin::bag
