// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "idl_support/topic_info.hpp"

namespace tocsin {

/// What a writer offers and a reader requests: the policies that decide whether they match.
struct QosContract {
  std::string reliability = "reliable";
  std::string durability = "volatile";
  double deadline_s = std::numeric_limits<double>::infinity();
  std::string liveliness = "automatic";
  double liveliness_lease_s = std::numeric_limits<double>::infinity();
  std::string ownership = "shared";
  std::vector<std::string> partition;

  template <class Visitor>
  void visit(Visitor& v) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    v("reliability", reliability, {"reliable", "best_effort"},
      "reliable repairs losses by retransmission");
    v("durability", durability, {"volatile", "transient_local"},
      "transient_local gives a late reader the last samples");
    v("deadline_s", deadline_s, {0.001, inf}, "[s] a longer gap between two samples is counted");
    v("liveliness", liveliness, {"automatic", "manual_by_participant", "manual_by_topic"},
      "what shows that a writer lives: its process, any write of it, its own writes");
    v("liveliness_lease_s", liveliness_lease_s, {0.01, inf},
      "[s] a writer that does not show it for longer counts as dead");
    v("ownership", ownership, {"shared", "exclusive"},
      "exclusive: readers hear only the living writer of the highest strength");
    v("partition", partition, "names, with wildcards; both ends must share one");
  }

  [[nodiscard]] bool reliable() const { return reliability == "reliable"; }
  [[nodiscard]] bool keeps_last() const { return durability == "transient_local"; }
  [[nodiscard]] bool exclusive() const { return ownership == "exclusive"; }
};

/// What each end keeps. Types here have no keys, so a topic has one instance.
struct QosHistory {
  std::string history = "keep_last";
  int depth = 1;
  double lifespan_s = std::numeric_limits<double>::infinity();
  int max_samples = 0;
  int allocated_samples = 1;
  int extra_samples = 1;
  std::string memory_policy = "dynamic_reusable";

  template <class Visitor>
  void visit(Visitor& v) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    v("history", history, {"keep_last", "keep_all"},
      "keep_all: a full reliable writer blocks for max_blocking_time_s, then refuses");
    v("depth", depth, {1, 10000}, "[1] samples kept by keep_last");
    v("lifespan_s", lifespan_s, {0.001, inf}, "[s] an older sample is never delivered");
    v("max_samples", max_samples, {0, 100000},
      "[1] samples an end has room for; 0: depth + 1, with keep_all 1000");
    v("allocated_samples", allocated_samples, {0, 10000}, "[1] room made at start");
    v("extra_samples", extra_samples, {0, 1000}, "[1] room for samples that are being sent");
    v("memory_policy", memory_policy, {"preallocated_with_realloc", "dynamic", "dynamic_reusable"},
      "how buffers of samples are taken and kept");
  }

  [[nodiscard]] bool keeps_all() const { return history == "keep_all"; }
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
  std::string publish_mode = "automatic";
  std::string flow_controller;
  int priority = 10;
  int bandwidth_reservation_percent = 0;
  int ownership_strength = 0;
  std::string requested_reliability = "offered";
  double max_rate_hz = std::numeric_limits<double>::infinity();
  double minimum_separation_s = 0;
  std::string user_data;

  template <class Visitor>
  void visit(Visitor& v) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    v("publish_mode", publish_mode, {"automatic", "synchronous", "asynchronous"},
      "automatic: asynchronous with a flow_controller, else synchronous");
    v("flow_controller", flow_controller, "one of flow_controllers; empty: unlimited");
    v("priority", priority, {-10, 10}, "[1] within the flow controller, -10 goes first");
    v("bandwidth_reservation_percent", bandwidth_reservation_percent, {0, 100},
      "[%] of the flow controller that is this writer's");
    v("ownership_strength", ownership_strength, {0, 1000000}, "[1] of an exclusive writer");
    v("requested_reliability", requested_reliability, {"offered", "best_effort"},
      "best_effort: readers hear every writer, and ask for no repair");
    v("max_rate_hz", max_rate_hz, {0.001, inf}, "[Hz] a writer drops and counts what is more");
    v("minimum_separation_s", minimum_separation_s, {0, 3600},
      "[s] a reader drops what follows the writer's last delivered sample sooner");
    v("user_data", user_data, "announced with each endpoint");
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

/// Names of the policies by which a reader that requests `requested` will not match a writer that
/// offers `offered`: DDS's rules, which all vendors follow. Empty when they match.
[[nodiscard]] std::vector<std::string> incompatibilities(const QosContract& offered,
                                                         const QosContract& requested);

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
