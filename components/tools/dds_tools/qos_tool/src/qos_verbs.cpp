// SPDX-License-Identifier: Apache-2.0
#include "qos_verbs.hpp"

#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "command_line/programs.hpp"
#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "lint.hpp"
#include "matches.hpp"
#include "profile_text.hpp"
#include "running.hpp"
#include "runtime/middleware/traffic_rules.hpp"
#include "vendor_xml.hpp"

namespace tocsin::qos_tool::qos_verb {
namespace {

/// Findings, and pairs that do not match: the answer is no.
constexpr int negative = 1;

void print(const std::string& text) { std::printf("%s", text.c_str()); }
void print(const nlohmann::json& json) { print(json.dump(2) + "\n"); }

std::string shipped(const std::string& given, const char* name) {
  return given.empty() ? (share_folder(own_program()) / "config" / name).string() : given;
}

QosProfiles profiles_of(const Options& options) {
  return QosProfiles(shipped(options.file, "qos.yaml"));
}

}  // namespace

int list(const Options& options) {
  const QosProfiles profiles = profiles_of(options);
  options.json ? print(list_json(profiles, known_uses()))
               : print(list_text(profiles, known_uses()));
  return 0;
}

int show(const Options& options) {
  const QosProfiles profiles = profiles_of(options);
  const QosProfile& profile = find_profile(profiles, options.one);
  options.json ? print(show_json(options.one, profile))
               : print(show_text(options.one, profile, options.all));
  return 0;
}

int explain(const Options& options) {
  const QosProfiles profiles = profiles_of(options);
  print(explain_text(options.one, find_profile(profiles, options.one), known_uses()));
  return 0;
}

int diff(const Options& options) {
  const QosProfiles profiles = profiles_of(options);
  const QosProfile& one = find_profile(profiles, options.one);
  const QosProfile& other = find_profile(profiles, options.other);
  options.json ? print(diff_json(one, other)) : print(diff_text(one, other));
  return 0;
}

namespace {

bool is_topic(const std::string& name) { return !name.empty() && name.front() == '/'; }

/// The writers or readers that `name` means.
std::vector<End> ends_called(const Options& options, const std::string& name, bool writers,
                             const std::vector<GraphEnd>& running) {
  if (!is_topic(name)) {
    const QosProfiles profiles = profiles_of(options);
    const QosProfile& profile = find_profile(profiles, name);
    return {writers ? writer_of(name, profile) : reader_of(name, profile)};
  }
  std::vector<End> ends = ends_of(running, wire_name(options.host, name), writers);
  if (ends.empty()) {
    throw EnvironmentError(name + ": nobody " + (writers ? "writes" : "reads") + " it here" +
                           like_running(running, name));
  }
  return ends;
}

}  // namespace

int match(const Options& options) {
  const std::string& other = options.other.empty() ? options.one : options.other;
  std::vector<GraphEnd> running;
  if (is_topic(options.one) || is_topic(other)) running = ends_of_host(options);
  const auto pairs = pairs_of(ends_called(options, options.one, true, running),
                              ends_called(options, other, false, running));
  options.json ? print(match_json(pairs)) : print(match_text(pairs, options.all));
  return stopped(pairs).empty() ? 0 : negative;
}

namespace {

void complete(LintInput& input, const Options& options) {
  input.outage_s = options.outage_s;
  if (options.clocks_are_synchronised) input.clock_offset_s = 0;
}

/// Topics as the shipped or given files have them.
LintInput own_input(const Options& options) {
  const QosProfiles profiles = profiles_of(options);
  const std::string traffic = shipped(options.traffic, "traffic.yaml");
  LintInput input;
  input.profiles = profiles.all();
  std::map<std::string, TrafficRule> rules = TrafficRules(traffic, Role::uxv).all();
  rules.merge(std::map(TrafficRules(traffic, Role::gcs).all()));
  for (const TopicUse& use : known_uses()) {
    LintTopic topic{use.topic, use.profile};
    if (use.crosses_link) topic.way = options.direct ? Way::direct : Way::routed;
    const auto rule = rules.find(use.topic);
    if (rule != rules.end()) {
      topic.is_stream = rule->second.adaptive;
      topic.traffic_class = rule->second.traffic_class;
    }
    input.topics.push_back(topic);
  }
  return input;
}

}  // namespace

int lint_files(const Options& options) {
  LintInput input = own_input(options);
  complete(input, options);
  mark_streams(input, options.streams, shipped(options.file, "qos.yaml"));
  const auto findings = lint(input);
  options.json ? print(lint_json(findings)) : print(lint_text(findings));
  return findings.empty() ? 0 : negative;
}

int export_profiles(const Options& options) {
  const QosProfiles profiles = profiles_of(options);
  std::map<std::string, QosProfile> chosen;
  for (const std::string& name : options.profiles) chosen[name] = find_profile(profiles, name);
  static const std::map<std::string, Vendor> vendors{{"fastdds", Vendor::fast_dds},
                                                     {"fastdds3", Vendor::fast_dds_3},
                                                     {"cyclone", Vendor::cyclone}};
  const auto exported =
      export_xml(vendors.at(options.vendor), options.profiles.empty() ? profiles.all() : chosen);
  print(exported.xml);
  for (const std::string& one : exported.lost) {
    std::fprintf(stderr, "lost: %s\n", error_line(one).c_str());
  }
  return 0;
}

int set(const Options& options) {
  const Changed done = change_running(options);
  if (options.json) {
    print(nlohmann::json{{"topic", options.one},
                         {"ends", done.ends},
                         {"containers", done.containers},
                         {"stopped", match_json(done.stopped)}});
  } else {
    std::printf("%s: changed %d ends in %d containers\n", printable(options.one).c_str(), done.ends,
                done.containers);
    print(match_text(done.stopped, false));
  }
  return done.stopped.empty() ? 0 : negative;
}

int tune(const Options& options) { return run_tune(options.tune); }

}  // namespace tocsin::qos_tool::qos_verb
