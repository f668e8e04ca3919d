// SPDX-License-Identifier: Apache-2.0
#include "report/recording.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "deployment/deployment.hpp"
#include "deployment/traffic_file.hpp"
#include "foundation/csv_table.hpp"
#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/yaml_file.hpp"
#include "report/link_log.hpp"
#include "run_tables.hpp"

namespace tocsin::report {
namespace {

/// What a router gives later of a topic, it gives on this one.
constexpr const char* backfilled_suffix = "/backfilled";

/// The topic that this one fills in; empty when it is none.
std::optional<std::string> topic_backfilled(const std::string& topic) {
  const std::string suffix = backfilled_suffix;
  const bool is_one = topic.size() > suffix.size() &&
                      topic.compare(topic.size() - suffix.size(), suffix.size(), suffix) == 0;
  return is_one ? std::optional(topic.substr(0, topic.size() - suffix.size())) : std::nullopt;
}

/// Send times of the samples of a topic that the receiver's own side has written. Only topics that
/// both sides write have a field `role`.
std::set<std::string> own_samples(RunTables& run, const std::string& topic, Role receiver) {
  std::set<std::string> own;
  const CsvTable table = run.of(receiver, topic);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (role_of(table.text(row, "role")) == receiver) own.insert(table.text(row, "send_s"));
  }
  return own;
}

Arrival arrival_of(const CsvTable& table, std::size_t row) {
  return {table.number(row, "send_s"),
          table.number(row, "receive_s"),
          table.text(row, "topic"),
          table.text(row, "writer"),
          std::strtoull(table.text(row, "sequence").c_str(), nullptr, 10),
          table.number(row, "bytes")};
}

/// Adds what `role` wrote, as its own recorder saw it.
void add_written(const Classes& classes, Role role, RunTables& run, Recording& recording) {
  std::map<std::string, std::uint64_t> rows;
  const CsvTable table = run.messages(role);
  for (std::size_t row = 0; row < table.rows(); ++row) ++rows[table.text(row, "topic")];
  for (const auto& [topic, link_class] : classes) {
    const std::size_t own = own_samples(run, topic, role).size();
    const auto found = rows.find(topic);
    recording.written[link_class] += own > 0 ? own : found == rows.end() ? 0 : found->second;
  }
}

/// Adds what `receiver` got from the other side.
void add_arrivals(const Classes& classes, Role receiver, RunTables& run, Recording& recording) {
  const CsvTable table = run.messages(receiver);
  std::map<std::string, std::set<std::string>> own;
  for (const auto& [topic, link_class] : classes) own[topic] = own_samples(run, topic, receiver);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    Arrival arrival = arrival_of(table, row);
    const auto backfilled = topic_backfilled(arrival.topic);
    if (backfilled) arrival.topic = *backfilled;
    const auto found = classes.find(arrival.topic);
    if (found == classes.end() || !std::isfinite(arrival.sent_s + arrival.received_s)) continue;
    if (own[arrival.topic].count(table.text(row, "send_s")) != 0) continue;
    auto& came = backfilled ? recording.backfilled : recording.arrivals;
    came[found->second].push_back(std::move(arrival));
  }
}

/// The table of a topic as the vehicle recorded it, else as the ground station did.
CsvTable vehicle_table(RunTables& run, const std::string& topic) {
  CsvTable table = run.of(Role::uxv, topic);
  return table.rows() > 0 ? table : run.of(Role::gcs, topic);
}

void add_decisions(RunTables& run, Recording& recording) {
  const CsvTable table = vehicle_table(run, "transmission_state");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (role_of(table.text(row, "role")) != Role::uxv) continue;
    const std::string& active = table.text(row, "active");
    recording.decisions.push_back({table.number(row, "send_s"), active == "true" || active == "1",
                                   table.text(row, "policy"), table.text(row, "reason"),
                                   table.number(row, "qni")});
  }
}

void add_qualities(RunTables& run, Recording& recording) {
  const CsvTable table = vehicle_table(run, "network_quality");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    recording.qualities.push_back({table.number(row, "send_s"), table.number(row, "per_percent"),
                                   table.number(row, "signal_dbm"),
                                   table.number(row, "rtt_mean_ms")});
  }
}

void add_path(RunTables& run, Recording& recording) {
  const CsvTable table = vehicle_table(run, "location");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    recording.path.push_back({table.number(row, "send_s"),
                              table.number(row, "pose.pose.position.x"),
                              table.number(row, "pose.pose.position.y")});
  }
}

/// `paths`: the list of a link_state, as JSON; empty before there was one.
bool is_by_second(const std::string& paths) {
  const auto both = nlohmann::json::parse(paths, nullptr, false);
  if (!both.is_array() || both.size() != 2 || !both[1].is_object()) return false;
  const auto chosen = both[1].find("chosen");
  return chosen != both[1].end() && (*chosen == 1 || *chosen == true);
}

/// What the router of a role told, as its own side recorded it, else as the other one did.
void add_router(Role role, RunTables& run, Recording& recording) {
  const Role other = role == Role::uxv ? Role::gcs : Role::uxv;
  for (const Role recorder : {role, other}) {
    const CsvTable table = run.of(recorder, "link_state");
    for (std::size_t row = 0; row < table.rows(); ++row) {
      const double time_s = table.number(row, "send_s");
      if (role_of(table.text(row, "role")) != role || !std::isfinite(time_s)) continue;
      const bool measured = table.number(row, "capacity_measured") == 1;
      recording.routers[role].push_back(
          {time_s, measured ? table.number(row, "capacity_bytes_per_s") : std::nan(""),
           table.number(row, "backlog_s"), is_by_second(table.text(row, "paths"))});
    }
    if (recording.routers.count(role) != 0) return;
  }
}

void add_mission(RunTables& run, Recording& recording) {
  const CsvTable table = run.of(Role::gcs, "mission_status");
  if (table.rows() == 0) return;
  const std::size_t last = table.rows() - 1;
  const auto whole = [&](const char* column) {
    const double value = table.number(last, column);
    constexpr double most = 1e9;  // what a peer sent may be any number
    return std::isfinite(value) ? static_cast<int>(std::clamp(value, 0.0, most)) : 0;
  };
  recording.mission = {table.text(last, "mission"), table.text(last, "state"),
                       whole("waypoint"),           whole("waypoints"),
                       whole("goals_sent"),         table.number(last, "elapsed_s")};
}

void find_limits(Recording& recording) {
  double begin_s = std::numeric_limits<double>::infinity();
  double end_s = -begin_s;
  const auto widen = [&](double time_s) {
    begin_s = std::min(begin_s, time_s);
    end_s = std::max(end_s, time_s);
  };
  for (const auto* came : {&recording.arrivals, &recording.backfilled}) {
    for (const auto& [link_class, arrivals] : *came) {
      for (const Arrival& arrival : arrivals) widen(arrival.received_s);
    }
  }
  for (const Decision& decision : recording.decisions) widen(decision.time_s);
  if (begin_s > end_s) {
    throw ConfigError(recording.folder + ": holds no recording (uxv/ and gcs/ bag)");
  }
  recording.begin_s = begin_s;
  recording.end_s = end_s;
}

/// Throws ConfigError for a word that is none.
TrafficClass class_named(const YAML::Node& word, const YamlSources& sources) {
  if (const auto found = traffic_class_of(word.Scalar())) return *found;
  throw ConfigError("'" + printable(word.Scalar()) + "' is no traffic class" +
                    yaml_place(sources, word));
}

}  // namespace

std::string to_string(const LinkClass& link_class) {
  return std::string(to_string(link_class.sender)) + " " + to_string(link_class.traffic_class);
}

Classes load_classes(const std::string& traffic_file, Role role, const std::string& share) {
  YamlSources sources;
  const YAML::Node traffic = deployment::read_traffic_file(traffic_file, share, sources);
  Classes classes;
  for (const auto& entry : traffic[to_string(role)]) {
    const LinkClass link_class{role, class_named(entry.first, sources)};
    for (const auto& topic : entry.second["topics"]) {
      classes.insert_or_assign(topic.Scalar(), link_class);
    }
  }
  return classes;
}

Recording load_recording(const std::string& folder) {
  Recording recording;
  recording.folder = folder;
  const auto deployment = deployment::load_resolved(folder + "/deployment.yaml");
  const Classes up = load_classes(deployment.traffic, Role::uxv, deployment.share);
  const Classes down = load_classes(deployment.traffic, Role::gcs, deployment.share);
  RunTables run(folder);
  add_arrivals(up, Role::gcs, run, recording);
  add_arrivals(down, Role::uxv, run, recording);
  add_written(up, Role::uxv, run, recording);
  add_written(down, Role::gcs, run, recording);
  add_decisions(run, recording);
  add_qualities(run, recording);
  add_router(Role::uxv, run, recording);
  add_router(Role::gcs, run, recording);
  add_mission(run, recording);
  add_path(run, recording);
  recording.link = read_link_log(folder + "/radio.jsonl");
  find_limits(recording);
  return recording;
}

}  // namespace tocsin::report
