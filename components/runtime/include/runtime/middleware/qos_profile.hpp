// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <map>
#include <string>

namespace tocsin {

/// What the writers of a topic offer and its readers request, in the words of the DDS policies.
struct QosProfile {
  std::string reliability = "reliable";
  std::string durability = "volatile";
  int depth = 1;
  double lifespan_s = std::numeric_limits<double>::infinity();
  double heartbeat_period_s = 0.2;
  double nack_response_delay_s = 0.0;
  double heartbeat_response_delay_s = 0.0;

  template <class Visitor>
  void visit(Visitor& v) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    v("reliability", reliability, {"reliable", "best_effort"},
      "reliable repairs losses by retransmission");
    v("durability", durability, {"volatile", "transient_local"},
      "transient_local gives a late reader the last samples");
    v("depth", depth, {1, 10000}, "[1] KEEP_LAST history of writer and reader");
    v("lifespan_s", lifespan_s, {0.001, inf}, "[s] an older sample is never delivered");
    v("heartbeat_period_s", heartbeat_period_s, {0.001, 3600},
      "[s] between heartbeats of a reliable writer with unacknowledged samples");
    v("nack_response_delay_s", nack_response_delay_s, {0, 10},
      "[s] a writer waits before it answers a negative acknowledgement");
    v("heartbeat_response_delay_s", heartbeat_response_delay_s, {0, 10},
      "[s] a reader waits before it answers a heartbeat");
  }

  [[nodiscard]] bool reliable() const { return reliability == "reliable"; }
  [[nodiscard]] bool keeps_last() const { return durability == "transient_local"; }
};

/// The profiles of one file, by name.
class QosProfiles {
 public:
  /// Reads config/qos.yaml. Throws ConfigError with file and line.
  explicit QosProfiles(const std::string& path);
  /// Throws ConfigError naming the topic when the profile is missing.
  [[nodiscard]] const QosProfile& of(const std::string& profile, const std::string& topic) const;

 private:
  std::string path_;
  std::map<std::string, QosProfile> profiles_;
};

}  // namespace tocsin
