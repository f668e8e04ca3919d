// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "foundation/enum_words.hpp"
#include "foundation/parameters.hpp"
#include "idl_support/topic_info.hpp"

namespace tocsin {

enum class Reliability { reliable, best_effort };
/// Weakest first. Profiles know the first two; other vendors and ROS 2 nodes may ask for all.
enum class Durability { volatile_kind, transient_local, transient, persistent };
/// What shows that a writer lives, weakest first.
enum class Liveliness { automatic, manual_by_participant, manual_by_topic };
enum class Ownership { shared, exclusive };
enum class History { keep_last, keep_all };
enum class MemoryPolicy { preallocated_with_realloc, dynamic, dynamic_reusable };
enum class PublishMode { synchronous, asynchronous };
/// In which order a reader gets the samples of several writers, weakest first.
enum class DestinationOrder { by_reception, by_source };
/// Of which samples a writer keeps together what belongs together, weakest first.
enum class PresentationScope { instance, topic, group };
/// How samples are encoded, as DDS numbers it.
enum class Representation { xcdr1, xml, xcdr2 };
/// What readers request: what writers offer, or less.
enum class RequestedReliability { offered, best_effort };

/// The words of a QoS file.
constexpr std::array<const char*, 2> words_of(Reliability) { return {"reliable", "best_effort"}; }
constexpr std::array<const char*, 4> words_of(Durability) {
  return {"volatile", "transient_local", "transient", "persistent"};
}
constexpr std::array<const char*, 3> words_of(Liveliness) {
  return {"automatic", "manual_by_participant", "manual_by_topic"};
}
constexpr std::array<const char*, 2> words_of(Ownership) { return {"shared", "exclusive"}; }
constexpr std::array<const char*, 2> words_of(History) { return {"keep_last", "keep_all"}; }
constexpr std::array<const char*, 3> words_of(MemoryPolicy) {
  return {"preallocated_with_realloc", "dynamic", "dynamic_reusable"};
}
constexpr std::array<const char*, 2> words_of(PublishMode) {
  return {"synchronous", "asynchronous"};
}
constexpr std::array<const char*, 2> words_of(DestinationOrder) {
  return {"by_reception", "by_source"};
}
constexpr std::array<const char*, 3> words_of(PresentationScope) {
  return {"instance", "topic", "group"};
}
constexpr std::array<const char*, 3> words_of(Representation) { return {"xcdr1", "xml", "xcdr2"}; }
constexpr std::array<const char*, 2> words_of(RequestedReliability) {
  return {"offered", "best_effort"};
}

struct Presentation {
  PresentationScope scope = PresentationScope::instance;
  bool coherent = false;
  bool ordered = false;
};

/// What a writer offers and a reader requests: the policies that decide whether they match.
struct QosContract {
  Reliability reliability = Reliability::reliable;
  Durability durability = Durability::volatile_kind;
  double deadline_s = std::numeric_limits<double>::infinity();
  Liveliness liveliness = Liveliness::automatic;
  double liveliness_lease_s = std::numeric_limits<double>::infinity();
  Ownership ownership = Ownership::shared;
  std::vector<std::string> partition;
  // What other vendors may offer and request; our own ends have these values.
  double latency_budget_s = 0;
  DestinationOrder destination_order = DestinationOrder::by_reception;
  Presentation presentation = {};
  std::vector<Representation> representations{Representation::xcdr1};  ///< never empty

  template <class Visitor>
  void visit(Visitor& v) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    visit_enum(v, "reliability", reliability, Choices{"reliable", "best_effort"},
               "reliable repairs losses by retransmission");
    visit_enum(v, "durability", durability, Choices{"volatile", "transient_local"},
               "transient_local gives a late reader the last samples");
    v("deadline_s", deadline_s, {0.001, inf}, "[s] a longer gap between two samples is counted");
    visit_enum(v, "liveliness", liveliness,
               Choices{"automatic", "manual_by_participant", "manual_by_topic"},
               "what shows that a writer lives: its process, any write of it, its own writes");
    v("liveliness_lease_s", liveliness_lease_s, {0.01, inf},
      "[s] a writer that does not show it for longer counts as dead");
    visit_enum(v, "ownership", ownership, Choices{"shared", "exclusive"},
               "exclusive: readers hear only the living writer of the highest strength");
    v("partition", partition, "names, with wildcards; both ends must share one");
  }

  [[nodiscard]] bool reliable() const { return reliability == Reliability::reliable; }
  [[nodiscard]] bool keeps_last() const { return durability == Durability::transient_local; }
  [[nodiscard]] bool exclusive() const { return ownership == Ownership::exclusive; }
};

/// What each end keeps, of each instance if the type has a key.
struct QosHistory {
  History history = History::keep_last;
  int depth = 1;
  double lifespan_s = std::numeric_limits<double>::infinity();
  int max_samples = 0;
  int allocated_samples = 1;
  int extra_samples = 1;
  MemoryPolicy memory_policy = MemoryPolicy::dynamic_reusable;

  template <class Visitor>
  void visit(Visitor& v) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    visit_enum(v, "history", history, Choices{"keep_last", "keep_all"},
               "keep_all: a full reliable writer blocks for max_blocking_time_s, then refuses");
    v("depth", depth, {1, 10000}, "[1] samples of an instance kept by keep_last");
    v("lifespan_s", lifespan_s, {0.001, inf}, "[s] an older sample is never delivered");
    v("max_samples", max_samples, {0, 100000},
      "[1] samples of an instance an end has room for; 0: depth + 1, with keep_all 1000");
    v("allocated_samples", allocated_samples, {0, 10000}, "[1] room made at start");
    v("extra_samples", extra_samples, {0, 1000}, "[1] room for samples that are being sent");
    visit_enum(v, "memory_policy", memory_policy,
               Choices{"preallocated_with_realloc", "dynamic", "dynamic_reusable"},
               "how buffers of samples are taken and kept");
  }

  [[nodiscard]] bool keeps_all() const { return history == History::keep_all; }
  /// `max_samples`, or what its 0 stands for.
  [[nodiscard]] int room() const;
};

/// When the two ends of a reliable topic talk to each other.
struct QosTiming {
  double max_blocking_time_s = 0.1;
  double initial_heartbeat_delay_s = 0.012;
  double heartbeat_period_s = 0.2;
  double nack_response_delay_s = 0.0;
  double nack_suppression_s = 0.0;
  bool heartbeat_piggyback = true;
  double initial_acknack_delay_s = 0.07;
  double heartbeat_response_delay_s = 0.0;
  double liveliness_announcement_s = std::numeric_limits<double>::infinity();

  template <class Visitor>
  void visit(Visitor& v) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    v("max_blocking_time_s", max_blocking_time_s, {0, 10},
      "[s] a write into a full keep_all history waits; keep_last never does");
    v("initial_heartbeat_delay_s", initial_heartbeat_delay_s, {0, 10},
      "[s] before the first heartbeat to a new reader");
    v("heartbeat_period_s", heartbeat_period_s, {0.001, 3600},
      "[s] between heartbeats of a reliable writer with unacknowledged samples");
    v("nack_response_delay_s", nack_response_delay_s, {0, 10},
      "[s] a writer waits before it answers a negative acknowledgement");
    v("nack_suppression_s", nack_suppression_s, {0, 10},
      "[s] a negative acknowledgement that comes sooner after the sample is ignored");
    v("heartbeat_piggyback", heartbeat_piggyback, "heartbeats ride on data when the history fills");
    v("initial_acknack_delay_s", initial_acknack_delay_s, {0, 10},
      "[s] before a reader first tells a new writer what it lacks");
    v("heartbeat_response_delay_s", heartbeat_response_delay_s, {0, 10},
      "[s] a reader waits before it answers a heartbeat");
    v("liveliness_announcement_s", liveliness_announcement_s, {0.005, inf},
      "[s] between signs of life; infinite: a third of a finite lease");
  }
};

/// How samples leave a writer, and which of them reach a reader.
struct QosDelivery {
  PublishMode publish_mode = PublishMode::synchronous;
  int ownership_strength = 0;
  RequestedReliability requested_reliability = RequestedReliability::offered;
  double max_rate_hz = std::numeric_limits<double>::infinity();
  double minimum_separation_s = 0;
  std::string user_data;

  template <class Visitor>
  void visit(Visitor& v) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    visit_enum(v, "publish_mode", publish_mode, Choices{"synchronous", "asynchronous"},
               "whether a thread of Fast DDS sends, or who writes");
    v("ownership_strength", ownership_strength, {0, 1000000}, "[1] of an exclusive writer");
    visit_enum(v, "requested_reliability", requested_reliability, Choices{"offered", "best_effort"},
               "best_effort: readers hear every writer, and ask for no repair");
    v("max_rate_hz", max_rate_hz, {0.001, inf}, "[Hz] a writer drops and counts what is more");
    v("minimum_separation_s", minimum_separation_s, {0, 3600},
      "[s] a reader drops what follows the writer's last delivered sample sooner");
    v("user_data", user_data,
      "announced with each endpoint; pairs key=value; of letters and digits");
  }

  [[nodiscard]] bool thins() const {
    return minimum_separation_s > 0 || max_rate_hz < std::numeric_limits<double>::infinity();
  }
};

/// A profile of config/qos.yaml: what the writers of a topic offer and its readers request.
struct QosProfile : QosContract, QosHistory, QosTiming, QosDelivery {
  template <class Visitor>
  void visit(Visitor& v) {
    QosContract::visit(v);
    QosHistory::visit(v);
    QosTiming::visit(v);
    QosDelivery::visit(v);
  }
};

/// What the readers of a topic request whose writers offer `offered`: the same, less reliability if
/// the profile says so, or nothing at all, see Requests. Readers that request nothing keep 16
/// samples, so that one writer's sample does not push out another's before it is taken.
[[nodiscard]] QosProfile requested(const TopicInfo& topic, QosProfile offered);

/// A rule across policies that a profile breaks.
struct QosConflict {
  std::string policy;  ///< key of the profile
  std::string reason;
};
/// The first broken rule of a profile whose values are each in range.
[[nodiscard]] std::optional<QosConflict> conflict(const QosProfile& profile);

/// Why a DDS policy, by its key, cannot be had on Fast DDS 2.9.1; empty when it can, or when there
/// is no such policy. `value` matters where only some of the values are refused.
[[nodiscard]] std::string refusal(const std::string& key, const std::string& value);

}  // namespace tocsin
