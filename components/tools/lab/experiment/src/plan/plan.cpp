// SPDX-License-Identifier: Apache-2.0
#include "plan/plan.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>

#include "foundation/error.hpp"

namespace tocsin::experiment {
namespace {

namespace fs = std::filesystem;

template <class Entry>
const Entry& named(const std::vector<Entry>& entries, const std::string& name) {
  return *std::find_if(entries.begin(), entries.end(),
                       [&](const Entry& entry) { return entry.name == name; });
}

/// The channel for one mission.
Channel channel_for(Channel channel, const std::string& mission) {
  const std::string variable = "${mission}";
  const std::size_t at = channel.file.find(variable);
  if (at != std::string::npos) channel.file.replace(at, variable.size(), mission);
  if (fs::is_regular_file(channel.file)) return channel;
  throw ConfigError("channels." + channel.name + ": no file '" + channel.file + "'");
}

/// "key=value" belongs to the transmission controller, "component.key=value" to the component.
std::string setting(const std::string& text) {
  const std::size_t equals = text.find('=');
  const bool whole = text.find('.') < equals;
  return whole ? text : "transmission_controller." + text;
}

std::string bringup_file(const std::string& name, const std::string& share) {
  const fs::path shared = fs::path(share) / "bringup" / name;
  const bool bare = name.find('/') == std::string::npos && !fs::exists(name);
  return bare && fs::exists(shared) ? shared.string() : name;
}

/// Where a bringup has cameras, as `--without` names them.
std::vector<std::string> cameras_of(const deployment::Deployment& deployment) {
  std::vector<std::string> cameras;
  for (const deployment::Host& host : deployment.hosts) {
    for (const deployment::Container& container : host.containers) {
      for (const deployment::ComponentInstance& one : container.components) {
        if (one.component != "camera") continue;
        cameras.push_back(host.name + "/" + container.name + "/" + one.name);
      }
    }
  }
  return cameras;
}

/// Calls `add` for each combination of a set, seeds innermost.
template <class Add>
void for_each_combination(const RunSet& set, Add add) {
  for (const std::string& mission : set.missions) {
    for (const std::string& channel : set.channels) {
      for (const std::string& payload : set.payloads) {
        for (const std::string& policy : set.policies) add(mission, channel, payload, policy);
      }
    }
  }
}

}  // namespace

std::string Run::id() const {
  return set + "." + mission.name + "." + channel.name + "." + payload.name + "." + policy.name +
         "." + std::to_string(index);
}

std::string identity_of(const Run& run) {
  std::string text = run.mission.file + '\n' + run.channel.file + '\n' + std::to_string(run.seed) +
                     (run.payload.camera ? " camera " : " plain ") + run.policy.policy;
  for (const std::string& file : {run.policy.qos, run.policy.traffic}) {
    if (!file.empty()) text += ' ' + file;
  }
  for (const auto* list : {&run.mission.set, &run.fitted, &run.payload.set, &run.policy.set}) {
    text += '\n';
    for (const std::string& one : *list) text += one + ' ';
  }
  return text;
}

int seed_of(const std::string& mission, const std::string& channel, int index) {
  // FNV-1a; the seed of a bringup file is a positive int.
  std::uint32_t hash = 2166136261U;
  for (const char c : mission + "/" + channel + "/" + std::to_string(index)) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  }
  return static_cast<int>(hash % 1'000'000'000U) + 1;
}

std::vector<Run> make_plan(const Experiment& experiment) {
  std::vector<Run> plan;
  for (const RunSet& set : experiment.sets) {
    for_each_combination(set, [&](const std::string& mission, const std::string& channel,
                                  const std::string& payload, const std::string& policy) {
      Run run;
      run.set = set.name;
      run.mission = named(experiment.missions, mission);
      run.channel = channel_for(named(experiment.channels, channel), mission);
      run.payload = named(experiment.payloads, payload);
      run.policy = named(experiment.policies, policy);
      for (int i = 0; i < set.seeds; ++i) {
        run.number = plan.size();
        run.index = set.first_seed + i;
        const int fit = fit_of(run.index, experiment.timing.fits);
        run.fitted = settings_for(experiment.fitted, fitted_key(mission, fit), run.policy.policy);
        const std::string& seeds_of = run.channel.seeds_of;
        run.seed = seed_of(mission, seeds_of.empty() ? channel : seeds_of, run.index);
        plan.push_back(run);
      }
    });
  }
  return plan;
}

deployment::Overrides overrides_of(const Run& run, const Timing& timing, const std::string& share,
                                   const std::string& run_dir) {
  deployment::Overrides overrides;
  overrides.share = share;
  overrides.run_dir = run_dir;
  overrides.seed = run.seed;
  overrides.channel = run.channel.file;
  overrides.without = timing.without;
  overrides.qos = run.policy.qos;
  overrides.traffic = run.policy.traffic;
  overrides.set.push_back("mission_control.mission_file=" + run.mission.file);
  overrides.set.push_back("transmission_controller.policy=" + run.policy.policy);
  for (const std::string& text : run.mission.set) overrides.set.push_back(text);
  for (const std::string& text : run.fitted) overrides.set.push_back(setting(text));
  for (const std::string& text : run.payload.set) overrides.set.push_back(text);
  for (const std::string& text : run.policy.set) overrides.set.push_back(setting(text));
  if (run.payload.camera) return overrides;
  const auto whole = deployment::load_deployment(bringup_file(timing.bringup, share), overrides);
  for (const std::string& camera : cameras_of(whole)) overrides.without.push_back(camera);
  return overrides;
}

deployment::Deployment deployment_of(const Run& run, const Timing& timing, const std::string& share,
                                     const std::string& run_dir) {
  return deployment::load_deployment(bringup_file(timing.bringup, share),
                                     overrides_of(run, timing, share, run_dir));
}

void instrument(deployment::Deployment& deployment) {
  for (deployment::Host& host : deployment.hosts) {
    for (deployment::Container& container : host.containers) {
      for (deployment::ComponentInstance& one : container.components) {
        if (one.component != "recorder") continue;
        one.component = "experiment";
        one.parameters = std::make_shared<const YAML::Node>(YAML::NodeType::Map);
      }
    }
  }
}

}  // namespace tocsin::experiment
