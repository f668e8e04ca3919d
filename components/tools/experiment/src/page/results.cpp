// SPDX-License-Identifier: Apache-2.0
#include "page/results.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "foundation/csv_table.hpp"
#include "foundation/error.hpp"
#include "foundation/yaml_file.hpp"
#include "page/inference.hpp"
#include "report/statistics.hpp"
#include "results/result_store.hpp"

namespace tocsin::experiment {
namespace {

namespace fs = std::filesystem;

std::string read_text(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

bool same_round(const Group& a, const Group& b) {
  return a.set == b.set && a.mission == b.mission && a.channel == b.channel &&
         a.payload == b.payload;
}

Group group_of(const CsvTable& table, std::size_t row) {
  Group group;
  group.set = table.text(row, "set");
  group.mission = table.text(row, "mission");
  group.channel = table.text(row, "channel");
  group.payload = table.text(row, "payload");
  group.policy = table.text(row, "policy");
  return group;
}

std::string id_of(const Group& group, int index) {
  return group.set + "." + group.mission + "." + group.channel + "." + group.payload + "." +
         group.policy + "." + std::to_string(index);
}

/// Of what is no number no run has a file, which is told then.
int index_of(const CsvTable& table, std::size_t row) {
  const double number = table.number(row, "index");
  return number >= 0 && number < 1e9 ? static_cast<int>(number) : -1;
}

/// Adds the runs of one table to `groups`; rows of a group follow each other.
void add_runs(const std::string& folder, const std::string& table_name, const std::string& kind,
              std::vector<Group>& groups, Results& results) {
  const auto table = CsvTable::read(folder + "/" + table_name);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    Group group = group_of(table, row);
    const int index = index_of(table, row);
    const std::string id = id_of(group, index);
    if (groups.empty() || !same_round(groups.back(), group) ||
        groups.back().policy != group.policy) {
      groups.push_back(std::move(group));
    }
    const auto result = parse_result(read_text(folder + "/" + kind + "/" + id + ".csv"));
    const bool good = result && result->failure.empty();
    if (!good) results.failures.push_back(id + ": " + (result ? result->failure : "damaged file"));
    ++results.runs;
    groups.back().indices.push_back(index);
    groups.back().values.push_back(good ? result->measures.values : std::vector<double>{});
    groups.back().series.push_back(good ? result->measures.series : std::vector<Observation>{});
  }
}

/// The fitted parameters among the files of settings.yaml, which are named by their whole paths.
Fitted fitted_of(const YAML::Node& settings, const std::string& name) {
  if (name.empty()) return {};
  const std::string end = "/" + fs::path(name).filename().string();
  for (const auto& file : settings["files"]) {
    const std::string path = file.first.as<std::string>("");
    const bool is_it =
        path.size() > end.size() && path.compare(path.size() - end.size(), end.size(), end) == 0;
    if (is_it) return parse_fitted(file.second.as<std::string>(""), path);
  }
  return {};
}

/// The values of all runs at observation `i`.
std::vector<double> column(const Group& group, std::size_t i,
                           const std::function<double(const Observation&)>& value) {
  std::vector<double> values;
  for (const auto& series : group.series) {
    if (i < series.size() && std::isfinite(value(series[i]))) values.push_back(value(series[i]));
  }
  return values;
}

template <class Summary>
std::vector<double> over_observations(const Group& group,
                                      const std::function<double(const Observation&)>& value,
                                      Summary summary) {
  std::vector<double> result;
  for (std::size_t i = 0;; ++i) {
    const auto reached = std::count_if(group.series.begin(), group.series.end(),
                                       [i](const auto& series) { return i < series.size(); });
    if (reached == 0 || 2 * reached < static_cast<long>(group.series.size())) return result;
    result.push_back(summary(column(group, i, value)));
  }
}

}  // namespace

std::vector<double> Group::metric(Metric metric) const {
  const std::size_t index = index_of(metric);
  std::vector<double> all;
  for (const auto& run : values) all.push_back(run.empty() ? std::nan("") : run[index]);
  return all;
}

Results load_results(const std::string& folder) {
  const bool any = fs::exists(folder + "/runs.csv") || fs::exists(folder + "/real.csv");
  if (!fs::exists(folder + "/settings.yaml") || !any) {
    throw ConfigError(folder +
                      ": holds no results of tocsin experiment run (settings.yaml, runs.csv or "
                      "real.csv)");
  }
  Results results;
  results.folder = folder;
  results.settings = read_text(folder + "/settings.yaml");
  const YAML::Node settings = read_yaml_file(folder + "/settings.yaml");
  results.build = settings["build"].as<std::string>("unknown");
  for (const YAML::Node& earlier : settings["earlier_builds"]) {
    results.build += ", earlier runs " + earlier.as<std::string>("");
  }
  results.experiment =
      parse_experiment(settings["experiment"].as<std::string>(""), folder + "/settings.yaml");
  results.fitted = fitted_of(settings, results.experiment.timing.fitted);
  add_runs(folder, "runs.csv", "series", results.groups, results);
  const std::size_t simulated = results.runs;
  add_runs(folder, "real.csv", "real", results.real, results);
  results.runs = simulated;
  return results;
}

const Group* find_group(const std::vector<Group>& groups, const Group& like,
                        const std::string& policy) {
  for (const Group& group : groups) {
    if (same_round(group, like) && group.policy == policy) return &group;
  }
  return nullptr;
}

std::vector<std::vector<const Group*>> rounds_of(const std::vector<Group>& groups,
                                                 const std::string& set) {
  std::vector<std::vector<const Group*>> rounds;
  for (const Group& group : groups) {
    if (group.set != set) continue;
    if (rounds.empty() || !same_round(*rounds.back().front(), group)) rounds.emplace_back();
    rounds.back().push_back(&group);
  }
  return rounds;
}

std::vector<double> mean_series(const Group& group,
                                const std::function<double(const Observation&)>& value) {
  return over_observations(group, value,
                           [](const std::vector<double>& all) { return estimate(all).mean; });
}

std::vector<double> percentile_series(const Group& group,
                                      const std::function<double(const Observation&)>& value,
                                      double share) {
  return over_observations(group, value, [share](const std::vector<double>& all) {
    return report::percentile(all, share);
  });
}

}  // namespace tocsin::experiment
