// SPDX-License-Identifier: Apache-2.0
#include "tune/tune_plan.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "foundation/parameters.hpp"
#include "foundation/role.hpp"
#include "foundation/traffic_class.hpp"
#include "foundation/yaml_file.hpp"
#include "profile_text.hpp"
#include "runtime/middleware/qos_profile.hpp"
#include "runtime/middleware/traffic_rules.hpp"

namespace tocsin::qos_tool {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_candidates = 200;
const std::set<std::string> own_keys{"policy", "qos", "traffic", "seeds", "sweep"};

/// A setting's key, cut at its dots: `qos.stream.lifespan_s`, `class.uxv.camera/image_raw`.
struct SweepKey {
  enum class Target { qos, traffic_class, parameter } target;
  std::string owner;  ///< profile, role, component
  std::string name;   ///< policy, topic, key
};

SweepKey parse_key(const std::string& key, const std::string& place) {
  const std::size_t first = key.find('.');
  const std::size_t second = first == std::string::npos ? first : key.find('.', first + 1);
  const std::string head = key.substr(0, first);
  if (head == "qos" && second != std::string::npos) {
    return {SweepKey::Target::qos, key.substr(first + 1, second - first - 1),
            key.substr(second + 1)};
  }
  if (head == "class" && second != std::string::npos) {
    return {SweepKey::Target::traffic_class, key.substr(first + 1, second - first - 1),
            key.substr(second + 1)};
  }
  if (head != "qos" && head != "class" && first != std::string::npos && first > 0 &&
      first + 1 < key.size()) {
    return {SweepKey::Target::parameter, head, key.substr(first + 1)};
  }
  throw ConfigError("sweep: '" + key +
                    "' is none of qos.PROFILE.POLICY, class.ROLE.TOPIC, COMPONENT.KEY" + place);
}

std::vector<SweptSetting> read_sweep(const YAML::Node& root, const std::string& path) {
  const YAML::Node sweep = root["sweep"];
  if (!sweep || !sweep.IsMap() || sweep.size() == 0) {
    throw ConfigError("sweep: is no map of settings, each with its values" +
                      yaml_place(path, sweep ? sweep : root));
  }
  std::vector<SweptSetting> settings;
  for (const auto& entry : sweep) {
    SweptSetting setting{entry.first.Scalar(), {}};
    const std::string place = yaml_place(path, entry.first);
    (void)parse_key(setting.key, place);
    if (!entry.second.IsSequence() || entry.second.size() == 0) {
      throw ConfigError("sweep." + setting.key + ": is no list of values" + place);
    }
    for (const YAML::Node& value : entry.second) setting.values.push_back(YAML::Dump(value));
    settings.push_back(std::move(setting));
  }
  return settings;
}

/// Files of the experiment that are named relative to this one.
void make_absolute(YAML::Node experiment, const fs::path& folder) {
  const auto absolute = [&](YAML::Node node) {
    if (node && node.IsScalar()) node = (folder / node.Scalar()).lexically_normal().string();
  };
  for (const char* list : {"missions", "channels"}) {
    for (YAML::Node entry : experiment[list]) {
      if (entry.IsMap()) absolute(entry["file"]);
    }
  }
  absolute(experiment["fitted"]);
}

/// What the candidate sets of one kind, by owner.
std::map<std::string, std::vector<std::pair<std::string, std::string>>> settings_of(
    const Candidate& candidate, SweepKey::Target target) {
  std::map<std::string, std::vector<std::pair<std::string, std::string>>> found;
  for (const auto& [key, value] : candidate.settings) {
    const SweepKey one = parse_key(key, "");
    if (one.target == target) found[one.owner].emplace_back(one.name, value);
  }
  return found;
}

/// Topics that go to a class, and those of them that are adaptive, on demand or compressed.
struct ClassLists {
  std::vector<std::string> topics;
  std::vector<std::string> adaptive;
  std::vector<std::string> on_demand;
  std::vector<std::string> compress;

  void add(const std::string& topic, const TrafficRule& rule) {
    topics.push_back(topic);
    if (rule.adaptive) adaptive.push_back(topic);
    if (rule.on_demand) on_demand.push_back(topic);
    if (rule.compressed) compress.push_back(topic);
  }
  [[nodiscard]] std::string text() const {
    std::string text = "    topics: [" + joined(topics) + "]\n";
    if (!adaptive.empty()) text += "    adaptive: [" + joined(adaptive) + "]\n";
    if (!on_demand.empty()) text += "    on_demand: [" + joined(on_demand) + "]\n";
    if (!compress.empty()) text += "    compress: [" + joined(compress) + "]\n";
    return text;
  }
};

/// The part of a traffic file that moves these topics of a role to their classes.
std::string role_text(const TunePlan& plan, const std::string& role,
                      const std::vector<std::pair<std::string, std::string>>& topics) {
  const auto side = role_of(role);
  if (!side) throw ConfigError("sweep.class." + role + ": is none of the roles uxv, gcs");
  const TrafficRules rules(plan.params.traffic, *side);
  std::map<std::string, ClassLists> classes;
  for (const auto& [topic, wanted] : topics) {
    if (!traffic_class_of(wanted)) {
      throw ConfigError("sweep.class." + role + "." + topic + ": '" + wanted +
                        "' is none of critical, high, normal, low");
    }
    classes[wanted].add(topic, rules.of(topic));
  }
  std::string text = role + ":\n";
  for (const auto& [name, lists] : classes) text += "  " + name + ":\n" + lists.text();
  return text;
}

/// Refuses profiles, policies, roles, topics and classes that there are not, each value once,
/// before anything runs.
void check_sweep(const TunePlan& plan) {
  const QosProfiles profiles(plan.params.qos);
  for (const SweptSetting& setting : plan.sweep) {
    const SweepKey key = parse_key(setting.key, "");
    for (const std::string& value : setting.values) {
      (void)traffic_text(plan, {"", {{setting.key, value}}});
      if (key.target != SweepKey::Target::qos) continue;
      (void)find_profile(profiles, key.owner);
      YAML::Node changed(YAML::NodeType::Map);
      changed[key.name] = read_yaml_text(value, plan.path);
      (void)load_parameters<QosProfile>(changed, "sweep.qos." + key.owner, plan.path);
    }
  }
  (void)candidates_of(plan);  // refuses too many
}

}  // namespace

TunePlan read_tune_plan(const std::string& path, const std::string& shipped_config) {
  const YAML::Node root = read_yaml_file(path);
  if (!root.IsMap()) throw ConfigError("tune: is not a map" + yaml_place(path, root));
  const fs::path folder = fs::absolute(path).parent_path();
  TunePlan plan;
  plan.path = fs::absolute(path).string();
  plan.experiment = YAML::Node(YAML::NodeType::Map);
  YAML::Node own(YAML::NodeType::Map);
  for (const auto& entry : root) {
    const std::string key = entry.first.Scalar();
    if (key == "policies" || key == "sets") {
      throw ConfigError(key + ": are those of the sweep, and cannot be given" +
                        yaml_place(path, entry.first));
    }
    if (key == "sweep") continue;
    if (own_keys.count(key) != 0) {
      own.force_insert(entry.first, entry.second);
    } else {
      plan.experiment[key] = YAML::Clone(entry.second);
    }
  }
  make_absolute(plan.experiment, folder);
  plan.params = load_parameters<TunePlan::Params>(own, "tune", path);
  const auto found = [&](const std::string& given, const char* shipped) {
    return given.empty() ? shipped_config + "/" + shipped : (folder / given).string();
  };
  plan.params.qos = found(plan.params.qos, "qos.yaml");
  plan.params.traffic = found(plan.params.traffic, "traffic.yaml");
  plan.sweep = read_sweep(root, path);
  check_sweep(plan);
  return plan;
}

std::vector<Candidate> candidates_of(const TunePlan& plan) {
  std::vector<Candidate> grid{{"", {}}};
  for (const SweptSetting& setting : plan.sweep) {
    std::vector<Candidate> longer;
    for (const Candidate& one : grid) {
      for (const std::string& value : setting.values) {
        longer.push_back(one);
        longer.back().settings.emplace_back(setting.key, value);
      }
    }
    grid = std::move(longer);
    if (grid.size() > most_candidates) {
      throw ConfigError(plan.path + ": sweep: has more than " + std::to_string(most_candidates) +
                        " combinations");
    }
  }
  std::vector<Candidate> all{{"shipped", {}}};
  for (Candidate& one : grid) {
    one.name = "c" + std::to_string(all.size());
    all.push_back(std::move(one));
  }
  return all;
}

std::string settings_text(const Candidate& candidate) {
  std::vector<std::string> words;
  for (const auto& [key, value] : candidate.settings) words.push_back(key + "=" + value);
  return words.empty() ? "as shipped" : joined(words, " ");
}

std::string qos_text(const TunePlan& plan, const Candidate& candidate) {
  const auto profiles = settings_of(candidate, SweepKey::Target::qos);
  if (profiles.empty()) return "";
  std::string text = "extends: " + plan.params.qos + "\n";
  for (const auto& [profile, policies] : profiles) {
    text += profile + ":\n";
    for (const auto& [policy, value] : policies) text += "  " + policy + ": " + value + "\n";
  }
  return text;
}

std::string traffic_text(const TunePlan& plan, const Candidate& candidate) {
  const auto roles = settings_of(candidate, SweepKey::Target::traffic_class);
  if (roles.empty()) return "";
  std::string text = "extends: " + plan.params.traffic + "\n";
  for (const auto& [role, topics] : roles) text += role_text(plan, role, topics);
  return text;
}

std::string experiment_text(const TunePlan& plan, const std::vector<Candidate>& candidates) {
  YAML::Node file = YAML::Clone(plan.experiment);
  for (const Candidate& candidate : candidates) {
    YAML::Node choice;
    choice["name"] = candidate.name;
    choice["policy"] = plan.params.policy;
    if (!qos_text(plan, candidate).empty()) choice["qos"] = candidate.name + ".qos.yaml";
    if (!traffic_text(plan, candidate).empty()) {
      choice["traffic"] = candidate.name + ".traffic.yaml";
    }
    for (const auto& [key, value] : candidate.settings) {
      if (parse_key(key, "").target == SweepKey::Target::parameter) {
        choice["set"].push_back(key + "=" + value);
      }
    }
    file["policies"].push_back(choice);
  }
  YAML::Node set;
  set["name"] = "tune";
  set["title"] = "Candidates of " + fs::path(plan.path).filename().string();
  set["seeds"] = plan.params.seeds;
  file["sets"].push_back(set);
  return YAML::Dump(file) + "\n";
}

}  // namespace tocsin::qos_tool
