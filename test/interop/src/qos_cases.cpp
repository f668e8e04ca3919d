// SPDX-License-Identifier: Apache-2.0
#include "qos_cases.hpp"

#include <cmath>
#include <limits>
#include <sstream>

namespace tocsin::interop {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

/// Each of `values` offered against each of them requested.
void cross(std::vector<Case>& all, const std::string& policy,
           const std::vector<QosContract>& values) {
  for (const QosContract& offered : values) {
    for (const QosContract& requested : values) all.push_back({policy, offered, requested});
  }
}

/// Without best effort and transient local, which our QoS files refuse: old samples are sent as
/// repairs.
std::vector<QosContract> reliabilities_and_durabilities() {
  std::vector<QosContract> values(3);
  values[0].reliability = Reliability::best_effort;
  values[2].durability = Durability::transient_local;
  return values;
}

std::vector<QosContract> livelinesses() {
  std::vector<QosContract> values;
  for (const Liveliness kind :
       {Liveliness::automatic, Liveliness::manual_by_participant, Liveliness::manual_by_topic}) {
    for (const double lease_s : {inf, 20.0, 10.0}) {
      values.emplace_back();
      values.back().liveliness = kind;
      values.back().liveliness_lease_s = lease_s;
    }
  }
  return values;
}

}  // namespace

std::vector<Case> all_cases() {
  std::vector<Case> all;
  cross(all, "reliability, durability", reliabilities_and_durabilities());
  cross(all, "liveliness and its lease", livelinesses());
  std::vector<QosContract> deadlines(3);
  deadlines[1].deadline_s = 20;
  deadlines[2].deadline_s = 10;
  cross(all, "deadline", deadlines);
  std::vector<QosContract> ownerships(2);
  ownerships[1].ownership = Ownership::exclusive;
  cross(all, "ownership", ownerships);
  std::vector<QosContract> partitions(4);
  partitions[1].partition = {"a"};
  partitions[2].partition = {"b", "c"};
  partitions[3].partition = {"a*"};
  cross(all, "partition", partitions);
  all.pop_back();  // the same expression on both sides, see below
  return all;
}

std::string profile(const std::string& name, const QosContract& qos) {
  std::ostringstream text;
  text << name << ": {reliability: " << word_of(qos.reliability)
       << ", durability: " << word_of(qos.durability) << ", liveliness: " << word_of(qos.liveliness)
       << ", ownership: " << word_of(qos.ownership);
  if (std::isfinite(qos.deadline_s)) text << ", deadline_s: " << qos.deadline_s;
  if (std::isfinite(qos.liveliness_lease_s)) {
    text << ", liveliness_lease_s: " << qos.liveliness_lease_s;
  }
  if (!qos.partition.empty()) {
    text << ", partition: [";
    for (const std::string& one : qos.partition) text << "\"" << one << "\", ";
    text << "]";
  }
  text << "}\n";
  return text.str();
}

}  // namespace tocsin::interop
