// SPDX-License-Identifier: Apache-2.0
#include "plan/experiment_file.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/parameters.hpp"
#include "foundation/spelling.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin::experiment {
namespace {

namespace fs = std::filesystem;

bool is_name(const std::string& text) {
  constexpr const char* allowed = "abcdefghijklmnopqrstuvwxyz0123456789_";
  return !text.empty() && text.find_first_not_of(allowed) == std::string::npos;
}

/// One experiment file while it is read.
class Reader {
 public:
  Reader(const std::string& path, const YAML::Node& root)
      : path_(path), folder_(fs::absolute(path).parent_path()), root_(root) {
    if (!root_.IsMap()) fail(root_, "experiment: is not a map");
  }

  /// The scalar part of the file: what is not one of the lists.
  [[nodiscard]] Timing timing() const {
    YAML::Node rest(YAML::NodeType::Map);
    const std::set<std::string> lists{"missions", "channels", "payloads",
                                      "policies", "sets",     "cost"};
    for (const auto& entry : root_) {
      if (lists.count(entry.first.Scalar()) == 0) rest.force_insert(entry.first, entry.second);
    }
    auto timing = load_parameters<Timing>(rest, "experiment", path_);
    timing.cost = load_parameters<CostWeights>(root_["cost"], "experiment.cost", path_);
    return timing;
  }

  template <class Entry>
  [[nodiscard]] std::vector<Entry> list(const std::string& key) const {
    const YAML::Node found = root_[key];
    if (!found || !found.IsSequence() || found.size() == 0) {
      fail(found ? found : root_, "experiment." + key + ": is not a list with at least one entry");
    }
    std::vector<Entry> entries;
    std::set<std::string> names;
    for (const YAML::Node& node : found) {
      const std::string owner = key + "[" + std::to_string(entries.size()) + "]";
      Entry entry = load_parameters<Entry>(node, owner, path_);
      if (!is_name(entry.name)) {
        fail(node,
             owner + ".name: '" + entry.name + "' is not a name (lower-case letters, digits, '_')");
      }
      if (!names.insert(entry.name).second) fail(node, owner + ".name: " + entry.name + " twice");
      entries.push_back(std::move(entry));
    }
    return entries;
  }

  /// Fills an empty list with all names, and rejects a name that is not there.
  template <class Entry>
  void resolve(const std::vector<Entry>& entries, const std::string& set, const char* key,
               std::vector<std::string>& names) const {
    std::vector<std::string> known;
    for (const Entry& entry : entries) known.push_back(entry.name);
    if (names.empty()) names = known;
    for (const std::string& name : names) {
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      fail(node_of_set(set)[key], "sets." + set + "." + key + ": '" + name + "' is not one of [" +
                                      joined(known) + "]" + suggestion(known, name));
    }
  }

  /// Rejects a channel whose seeds are those of one that is not there.
  void check_seeds(const std::vector<Channel>& channels) const {
    for (std::size_t i = 0; i < channels.size(); ++i) {
      const std::string& wanted = channels[i].seeds_of;
      const bool known = std::any_of(channels.begin(), channels.end(),
                                     [&](const Channel& one) { return one.name == wanted; });
      if (wanted.empty() || known) continue;
      fail(root_["channels"][i],
           "channels[" + std::to_string(i) + "].seeds_of: '" + wanted + "' is not a channel");
    }
  }

  [[nodiscard]] std::string absolute(const std::string& file) const {
    return (folder_ / file).lexically_normal();
  }
  void require_file(const std::string& file, const std::string& key, std::size_t index) const {
    if (fs::is_regular_file(file)) return;
    fail(root_[key][index], key + "[" + std::to_string(index) + "].file: no file '" + file + "'");
  }

 private:
  [[nodiscard]] YAML::Node node_of_set(const std::string& name) const {
    for (const YAML::Node& node : root_["sets"]) {
      if (node["name"].Scalar() == name) return node;
    }
    return root_;
  }
  [[noreturn]] void fail(const YAML::Node& node, const std::string& what) const {
    throw ConfigError(what + yaml_place(path_, node));
  }

  std::string path_;
  fs::path folder_;
  YAML::Node root_;
};

void resolve_files(const Reader& reader, Experiment& experiment) {
  std::size_t index = 0;
  for (Mission& mission : experiment.missions) {
    mission.file = reader.absolute(mission.file);
    reader.require_file(mission.file, "missions", index++);
  }
  index = 0;
  for (Channel& channel : experiment.channels) {
    channel.file = reader.absolute(channel.file);
    if (channel.file.find("${mission}") == std::string::npos) {
      reader.require_file(channel.file, "channels", index);
    }
    ++index;
  }
  index = 0;
  for (PolicyChoice& choice : experiment.policies) {
    for (std::string* file : {&choice.qos, &choice.traffic}) {
      if (file->empty()) continue;
      *file = reader.absolute(*file);
      reader.require_file(*file, "policies", index);
    }
    ++index;
  }
}

void resolve_sets(const Reader& reader, Experiment& experiment) {
  for (RunSet& set : experiment.sets) {
    reader.resolve(experiment.missions, set.name, "missions", set.missions);
    reader.resolve(experiment.channels, set.name, "channels", set.channels);
    reader.resolve(experiment.payloads, set.name, "payloads", set.payloads);
    reader.resolve(experiment.policies, set.name, "policies", set.policies);
    if (set.title.empty()) set.title = set.name;
  }
}

Experiment read(const Reader& reader, const std::string& path) {
  Experiment experiment;
  experiment.file = fs::absolute(path);
  experiment.timing = reader.timing();
  experiment.missions = reader.list<Mission>("missions");
  experiment.channels = reader.list<Channel>("channels");
  reader.check_seeds(experiment.channels);
  experiment.payloads = reader.list<Payload>("payloads");
  experiment.policies = reader.list<PolicyChoice>("policies");
  experiment.sets = reader.list<RunSet>("sets");
  for (PolicyChoice& choice : experiment.policies) {
    if (choice.policy.empty()) choice.policy = choice.name;
  }
  resolve_sets(reader, experiment);
  if (experiment.timing.vehicles != 1) {
    throw ConfigError("experiment.vehicles: " + std::to_string(experiment.timing.vehicles) +
                      " is not possible, a bringup file has one vehicle: must be 1 (" + path + ")");
  }
  if (experiment.timing.warm_up_s >= experiment.timing.duration_s) {
    throw ConfigError("experiment.warm_up_s: must be less than duration_s (" + path + ")");
  }
  return experiment;
}

/// Each mission that is fitted at all needs as many fits as the runs take in turn.
void require_all_fits(const Experiment& experiment) {
  const int fits = experiment.timing.fits;
  for (const Mission& mission : experiment.missions) {
    if (experiment.fitted.count(mission.name) == 0) continue;
    for (int fit = 2; fit <= fits; ++fit) {
      if (experiment.fitted.count(fitted_key(mission.name, fit)) > 0) continue;
      throw ConfigError("experiment.fits: " + std::to_string(fits) + ", but " +
                        experiment.timing.fitted + " has fits of mission " + mission.name +
                        " up to " + std::to_string(fit - 1) +
                        "; `tocsin experiment fit` writes it");
    }
  }
}

}  // namespace

Experiment load_unfitted(const std::string& path) {
  const Reader reader(path, read_yaml_file(path));
  Experiment experiment = read(reader, path);
  resolve_files(reader, experiment);
  std::string& fitted = experiment.timing.fitted;
  if (!fitted.empty()) fitted = reader.absolute(fitted);
  return experiment;
}

Experiment load_experiment(const std::string& path) {
  Experiment experiment = load_unfitted(path);
  const std::string& fitted = experiment.timing.fitted;
  if (fitted.empty()) return experiment;
  if (!fs::is_regular_file(fitted)) {
    throw ConfigError("experiment.fitted: no file '" + fitted + "'; `tocsin experiment fit " +
                      path + "` writes it");
  }
  experiment.fitted = load_fitted(fitted);
  require_all_fits(experiment);
  return experiment;
}

Experiment parse_experiment(const std::string& text, const std::string& path) {
  return read(Reader(path, read_yaml_text(text, path)), path);
}

}  // namespace tocsin::experiment
