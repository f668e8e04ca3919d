// SPDX-License-Identifier: Apache-2.0
#include "writer_qos.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

namespace tocsin::bag_tool {
namespace {

using bag::OfferedQos;

constexpr int usual_depth = 10;
constexpr int most_depth = 10'000;
constexpr double ns_of_second = 1e9;

/// [s] One that is shorter than a QoS profile allows would keep the middleware busy: it counts as
/// none.
double shortest(double before_s, const std::optional<std::int64_t>& ns) {
  constexpr double least_s = 0.01;
  const double s = ns ? static_cast<double>(*ns) / ns_of_second : HUGE_VAL;
  return s < least_s ? before_s : std::min(before_s, s);
}

OfferedQos offer_of(const GraphEnd& writer) {
  OfferedQos offer;
  offer.reliability = writer.qos.reliable() ? OfferedQos::Reliability::reliable
                                            : OfferedQos::Reliability::best_effort;
  offer.durability = writer.qos.durability == Durability::volatile_kind
                         ? OfferedQos::Durability::volatile_kind
                         : OfferedQos::Durability::transient_local;
  offer.liveliness = writer.qos.liveliness == Liveliness::automatic
                         ? OfferedQos::Liveliness::automatic
                         : OfferedQos::Liveliness::manual_by_topic;
  offer.deadline_ns = bag::finite_ns(writer.qos.deadline_s);
  offer.lifespan_ns = bag::finite_ns(writer.lifespan_s);
  offer.liveliness_lease_ns = bag::finite_ns(writer.qos.liveliness_lease_s);
  return offer;
}

/// Lifespans: one that has no end is the longest.
double longest_lifespan_s(const std::vector<OfferedQos>& recorded) {
  constexpr double least_s = 0.001;  // what a QoS profile allows
  double longest = least_s;
  for (const OfferedQos& one : recorded) {
    const double s =
        one.lifespan_ns ? static_cast<double>(*one.lifespan_ns) / ns_of_second : HUGE_VAL;
    longest = std::max(longest, s);
  }
  return longest;
}

int depth_of(const std::vector<OfferedQos>& recorded) {
  int depth = 0;
  for (const OfferedQos& one : recorded) depth = std::max(depth, one.depth);
  return std::min(depth > 0 ? depth : usual_depth, most_depth);
}

}  // namespace

std::vector<OfferedQos> offered_by(const std::vector<const GraphEnd*>& writers) {
  std::vector<OfferedQos> offered;
  std::set<std::string> seen;
  for (const GraphEnd* writer : writers) {
    const OfferedQos offer = offer_of(*writer);
    if (seen.insert(bag::to_yaml({offer})).second) offered.push_back(offer);
  }
  return offered;
}

QosProfile writer_qos(const std::vector<OfferedQos>& recorded) {
  QosProfile qos;
  qos.depth = usual_depth;
  if (recorded.empty()) return qos;
  qos.reliability = Reliability::best_effort;
  for (const OfferedQos& one : recorded) {
    if (one.reliability != OfferedQos::Reliability::best_effort) {
      qos.reliability = Reliability::reliable;
    }
    if (one.durability == OfferedQos::Durability::transient_local) {
      qos.durability = Durability::transient_local;
    }
    if (one.history == OfferedQos::History::keep_all) qos.history = History::keep_all;
    qos.deadline_s = shortest(qos.deadline_s, one.deadline_ns);
    qos.liveliness_lease_s = shortest(qos.liveliness_lease_s, one.liveliness_lease_ns);
  }
  qos.depth = depth_of(recorded);
  qos.lifespan_s = longest_lifespan_s(recorded);
  // Nobody says on behalf of a recorded writer that it lives.
  qos.liveliness = Liveliness::automatic;
  if (conflict(qos)) {
    const Reliability reliability = qos.reliability;
    const Durability durability = qos.durability;
    qos = QosProfile();
    qos.reliability = reliability;
    qos.durability = durability;
    qos.depth = usual_depth;
  }
  return qos;
}

}  // namespace tocsin::bag_tool
