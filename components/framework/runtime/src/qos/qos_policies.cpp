// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/qos_policies.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

namespace tocsin {
namespace {

constexpr int keep_all_room = 1000;

std::optional<QosConflict> history_conflict(const QosProfile& qos) {
  if (!qos.keeps_all() && qos.max_samples != 0 && qos.max_samples < qos.depth) {
    return QosConflict{"max_samples", "is less than depth"};
  }
  if (qos.allocated_samples > qos.room()) {
    return QosConflict{"allocated_samples", "is more than max_samples has room for"};
  }
  if (qos.keeps_last() && !qos.reliable()) {
    return QosConflict{"durability",
                       "transient_local needs reliability: reliable; old samples are "
                       "sent as repairs"};
  }
  return std::nullopt;
}

std::optional<QosConflict> thinning_conflict(const QosProfile& qos) {
  if (qos.minimum_separation_s > qos.deadline_s) {
    return QosConflict{"minimum_separation_s", "is longer than deadline_s"};
  }
  if (1.0 / qos.max_rate_hz > qos.deadline_s) {
    return QosConflict{"max_rate_hz", "is too slow for deadline_s"};
  }
  if (qos.thins() && qos.keeps_last()) {
    return QosConflict{qos.minimum_separation_s > 0 ? "minimum_separation_s" : "max_rate_hz",
                       "drops samples, and durability: transient_local promises the last one"};
  }
  return std::nullopt;
}

std::optional<QosConflict> writer_conflict(const QosProfile& qos) {
  if (qos.ownership_strength != 0 && !qos.exclusive()) {
    return QosConflict{"ownership_strength", "means nothing without ownership: exclusive"};
  }
  if (std::isfinite(qos.liveliness_announcement_s) &&
      qos.liveliness_announcement_s >= qos.liveliness_lease_s) {
    return QosConflict{"liveliness_announcement_s", "must be shorter than liveliness_lease_s"};
  }
  return std::nullopt;
}

/// As ROS 2 reads it: one part that is none, and it drops all parts, the hash of the type included.
bool is_pair(const std::string& part) {
  const std::size_t equals = part.find('=');
  const bool complete = equals != std::string::npos && equals > 0 && equals + 1 < part.size();
  return complete && std::all_of(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(equals),
                                 [](unsigned char c) { return std::isalnum(c) != 0; });
}

std::optional<QosConflict> user_data_conflict(const QosProfile& qos) {
  const std::string& text = qos.user_data;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(';', at), text.size());
    if (!is_pair(text.substr(at, end - at))) {
      return QosConflict{"user_data", "must be pairs key=value; with keys of letters and digits"};
    }
    at = end + 1;
  }
  return std::nullopt;
}

}  // namespace

int QosHistory::room() const {
  if (max_samples != 0) return max_samples;
  return keeps_all() ? keep_all_room : depth + 1;
}

QosProfile requested(const TopicInfo& topic, QosProfile offered) {
  const bool everything = topic.requests == Requests::profile;
  if (!everything || offered.requested_reliability == RequestedReliability::best_effort) {
    offered.reliability = Reliability::best_effort;
  }
  if (everything) return offered;
  const QosContract least;
  offered.durability = Durability::volatile_kind;
  offered.deadline_s = least.deadline_s;
  offered.liveliness = least.liveliness;
  offered.liveliness_lease_s = least.liveliness_lease_s;
  offered.depth = std::max(offered.depth, 16);
  offered.max_samples = 0;
  return offered;
}

std::optional<QosConflict> conflict(const QosProfile& profile) {
  if (auto found = history_conflict(profile)) return found;
  if (auto found = thinning_conflict(profile)) return found;
  if (auto found = user_data_conflict(profile)) return found;
  return writer_conflict(profile);
}

std::string refusal(const std::string& key, const std::string& value) {
  static const std::map<std::string, const char*> reasons{
      {"latency_budget", "Fast DDS 2.9.1 announces it and does nothing"},
      {"transport_priority",
       "Fast DDS 2.9.1 announces it and does nothing; link_router has classes"},
      {"destination_order", "Fast DDS 2.9.1 orders by reception only"},
      {"presentation", "Fast DDS 2.9.1 announces it; coherent and ordered access are stubs"},
      {"time_based_filter",
       "Fast DDS 2.9.1 announces it and delivers everything; use minimum_separation_s"},
      {"durability_service", "Fast DDS 2.9.1 has no durability service"},
      {"writer_data_lifecycle", "who unregisters an instance does not dispose of it"},
      {"reader_data_lifecycle", "Fast DDS 2.9.1 ignores it"},
      {"max_instances", "any number of instances has room"},
      {"max_samples_per_instance", "use max_samples, which is for each instance"},
      {"entity_factory", "the runtime enables what it creates"},
      {"group_data", "Fast DDS 2.9.1 announces it; nobody reads it; use user_data"},
      {"topic_data", "Fast DDS 2.9.1 announces it; nobody reads it; use user_data"},
      {"data_sharing",
       "needs types of fixed size; types here are encoded, and every reader would cost a thread"},
      {"disable_positive_acks",
       "Fast DDS 2.9.1 crashes when a best-effort reader matches such a writer"},
      {"data_representation", "Fast DDS 2.9.1 always writes XCDR1"},
      {"type_consistency", "types match by name and layout; nothing is coerced"},
      {"flow_controller",
       "a process with one may end by an assertion of Fast DDS 3.1; link_router paces what "
       "crosses"},
      {"durability transient", "needs a database: each write would block for 4 to 14 ms"},
      {"durability persistent", "Fast DDS 2.9.1 does not support it"},
      {"memory_policy preallocated", "types here have no largest size"},
  };
  const auto found = reasons.find(key);
  if (found != reasons.end()) return found->second;
  constexpr const char* unit = "_s";
  if (key.size() > 2 && key.compare(key.size() - 2, 2, unit) == 0) {
    return refusal(key.substr(0, key.size() - 2), value);
  }
  const auto with_value = reasons.find(key + " " + value);
  return with_value != reasons.end() ? with_value->second : "";
}

}  // namespace tocsin
