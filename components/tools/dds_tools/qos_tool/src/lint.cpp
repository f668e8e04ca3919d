// SPDX-License-Identifier: Apache-2.0
#include "lint.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "foundation/error.hpp"
#include "foundation/spelling.hpp"
#include "runtime/middleware/qos_matching.hpp"

namespace tocsin::qos_tool {
namespace {

using Findings = std::vector<Finding>;

bool asks_for_repair(const QosProfile& profile) {
  return profile.reliable() && profile.requested_reliability == RequestedReliability::offered;
}

/// Calls `look` with each topic on one of the ways whose profile is known, and adds what it says.
template <class Look>
void each_topic(const LintInput& input, const char* rule, Findings& found, const Look& look) {
  for (const LintTopic& topic : input.topics) {
    const auto profile = input.profiles.find(topic.profile);
    if (profile == input.profiles.end()) continue;
    const std::string reason = look(topic, profile->second);
    if (!reason.empty()) {
      found.push_back({rule, "topic " + topic.name + " (" + topic.profile + ")", reason});
    }
  }
}

template <class Look>
void each_profile(const LintInput& input, const char* rule, Findings& found, const Look& look) {
  for (const auto& [name, profile] : input.profiles) {
    const std::string reason = look(profile);
    if (!reason.empty()) found.push_back({rule, "profile " + name, reason});
  }
}

void reliable_stream(const LintInput& input, const char* rule, Findings& found) {
  each_topic(input, rule, found, [](const LintTopic& topic, const QosProfile& profile) {
    if (!topic.is_stream) return std::string();
    if (topic.way == Way::direct && asks_for_repair(profile)) {
      return std::string(
          "a stream whose readers ask for repair: on a bad radio old samples are sent again in "
          "front of new ones; request best effort (requested_reliability: best_effort)");
    }
    const bool repaired = topic.way == Way::routed && policy_of(topic.traffic_class).repaired;
    return repaired ? std::string(
                          "a stream in a class that link_router repairs: its repairs take "
                          "the radio from commands; put it into normal or low")
                    : std::string();
  });
}

void keeps_everything(const LintInput& input, const char* rule, Findings& found) {
  each_profile(input, rule, found, [](const QosProfile& profile) {
    if (!profile.keeps_last() || !profile.keeps_all()) return std::string();
    return fmt::format(
        "transient_local with keep_all: a late reader gets up to {} old samples in a burst, and a "
        "full writer waits {} in each write for the slowest reader; use keep_last with the depth "
        "that a late reader needs",
        profile.room(), duration_text(profile.max_blocking_time_s));
  });
}

void short_lease(const LintInput& input, const char* rule, Findings& found) {
  each_topic(input, rule, found, [&](const LintTopic& topic, const QosProfile& profile) {
    if (topic.way != Way::direct || profile.liveliness_lease_s >= input.outage_s) {
      return std::string();
    }
    return fmt::format(
        "liveliness lease of {} on a radio with outages of {}: each outage declares the writer "
        "dead; watch the age of samples instead, or make the lease longer",
        duration_text(profile.liveliness_lease_s), duration_text(input.outage_s));
  });
}

void slow_heartbeat(const LintInput& input, const char* rule, Findings& found) {
  each_profile(input, rule, found, [](const QosProfile& profile) {
    const double allowed_s = std::min(1.0, profile.lifespan_s / 2);
    if (!asks_for_repair(profile) || profile.heartbeat_period_s <= allowed_s) return std::string();
    return fmt::format(
        "heartbeat each {}: a reader notices that the last sample was lost only with the next "
        "heartbeat, {}; 0.1 to 0.2 s is usual (Fast DDS's default is 3 s)",
        duration_text(profile.heartbeat_period_s),
        std::isinf(profile.lifespan_s)
            ? std::string("an order may wait that long")
            : "and its lifespan is " + duration_text(profile.lifespan_s));
  });
}

void foreign_clocks(const LintInput& input, const char* rule, Findings& found) {
  each_topic(input, rule, found, [&](const LintTopic& topic, const QosProfile& profile) {
    if (topic.way != Way::direct || profile.lifespan_s >= input.clock_offset_s) {
      return std::string();
    }
    return fmt::format(
        "lifespan of {} between computers whose clocks may differ by {}: a reader of Fast DDS "
        "compares the writer's wall clock with its own and drops every sample of a host that is "
        "behind; synchronise the clocks, or check the age by what both measure",
        duration_text(profile.lifespan_s), duration_text(input.clock_offset_s));
  });
}

[[noreturn]] void refuse_profile(const LintInput& input, const std::string& name,
                                 const std::string& file) {
  std::vector<std::string> names;
  for (const auto& one : input.profiles) names.push_back(one.first);
  throw ConfigError("--stream: '" + name + "' is not a profile of " + file +
                    did_you_mean(names, name, "it has"));
}

struct Rule {
  const char* name;
  void (*look)(const LintInput& input, const char* rule, Findings& found);
};

const std::vector<Rule>& rules() {
  static const std::vector<Rule> all{
      {"reliable-stream", reliable_stream}, {"keeps-everything", keeps_everything},
      {"short-lease", short_lease},         {"slow-heartbeat", slow_heartbeat},
      {"foreign-clocks", foreign_clocks},
  };
  return all;
}

}  // namespace

void mark_streams(LintInput& input, const std::vector<std::string>& profiles,
                  const std::string& file) {
  for (const std::string& profile : profiles) {
    if (input.profiles.count(profile) == 0) refuse_profile(input, profile, file);
    bool is_used = false;
    for (LintTopic& topic : input.topics) {
      if (topic.profile != profile) continue;
      topic.is_stream = is_used = true;
    }
    if (!is_used) input.topics.push_back({"of profile " + profile, profile, Way::direct, true});
  }
}

std::vector<Finding> lint(const LintInput& input) {
  Findings found;
  for (const Rule& rule : rules()) rule.look(input, rule.name, found);
  return found;
}

std::string lint_text(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& one : findings) {
    text += fmt::format("{}: {}: {}\n", one.rule, one.subject, one.reason);
  }
  return text.empty() ? "no known trap\n" : text;
}

nlohmann::json lint_json(const std::vector<Finding>& findings) {
  nlohmann::json all = nlohmann::json::array();
  for (const Finding& one : findings) {
    all.push_back({{"rule", one.rule}, {"subject", one.subject}, {"reason", one.reason}});
  }
  return all;
}

}  // namespace tocsin::qos_tool
