// SPDX-License-Identifier: Apache-2.0
#include "mission_traffic.hpp"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <map>

#include "deployment/deployment.hpp"
#include "foundation/yaml_file.hpp"
#include "geometry/wall_file.hpp"
#include "radio_channel/channel_files.hpp"
#include "simulation/sim_world.hpp"

namespace tocsin::bench {

namespace fs = std::filesystem;

std::string share() {
  return fs::canonical(fs::read_symlink("/proc/self/exe").parent_path() /
                       "../../bringup/share/tocsin")
      .string();
}

namespace {

router::StreamRule rule_of(const simulation::TopicEnd& end) {
  router::StreamRule rule;
  rule.name = end.process + "/" + end.topic;
  rule.traffic_class = end.traffic_class.value_or(TrafficClass::normal);
  rule.repaired = policy_of(rule.traffic_class).repaired;
  if (end.pausable) {
    rule.while_paused = end.drops ? router::WhilePaused::drop : router::WhilePaused::latest;
  }
  const bool lives_forever = !std::isfinite(end.lifespan_s);
  if (!lives_forever && end.lifespan_s > 0) rule.lifespan = seconds(end.lifespan_s);
  rule.durable = end.reliable && lives_forever;
  rule.adaptive = end.topic.find("camera") != std::string::npos;
  return rule;
}

class Recorder final : public simulation::Observer {
 public:
  explicit Recorder(MissionTraffic& traffic) : traffic_(traffic) {}
  void on_written(const simulation::Written& written) override {
    if (written.from.scope != Scope::link) return;
    const auto [place, is_new] = sources_.try_emplace(&written.from, sources_.size());
    if (is_new) {
      traffic_.sources.push_back(
          {written.from.topic,
           written.from.role == Role::uxv ? radio::Direction::uplink : radio::Direction::downlink,
           rule_of(written.from)});
    }
    traffic_.writes.push_back({written.time, place->second, written.bytes});
  }
  void on_echo(const simulation::Echo& echo) override {
    if (echo.received == never) traffic_.echoes.push_back(echo.sent);
  }
  void on_position(const simulation::BasePosition& base) override {
    traffic_.places.push_back({base.time, base.x_m, base.y_m});
  }
  void on_gate(const simulation::GateChange& gate) override {
    if (gate.host != "uxv" && gate.host != "/uxv") return;
    traffic_.gates.push_back({gate.time, gate.event != simulation::GateEvent::closed});
  }

 private:
  MissionTraffic& traffic_;
  std::map<const simulation::TopicEnd*, std::size_t> sources_{};
};

/// Mission, settings and channel as thesis.yaml says.
void set_as_thesis(const Mission& mission, deployment::Overrides& overrides) {
  const std::string folder = overrides.share + "/config/experiments/";
  const YAML::Node file = read_yaml_file(folder + "thesis.yaml");
  const YAML::Node entry = file["missions"][mission.b ? 1 : 0];
  const auto name = entry["name"].as<std::string>();
  for (const auto& one : entry["set"]) overrides.set.push_back(one.as<std::string>());
  overrides.set.push_back("mission_control.mission_file=" + folder +
                          entry["file"].as<std::string>());
  const YAML::Node fitted = read_yaml_file(folder + "fitted.yaml")[name];
  for (const char* key : {"every_policy", mission.policy.c_str()}) {
    if (mission.policy == "none" || !fitted[key]) continue;
    for (const auto& one : fitted[key]) {
      overrides.set.push_back("transmission_controller." + one.as<std::string>());
    }
  }
  auto channel = file["channels"][0]["file"].as<std::string>();
  channel.replace(channel.find("${mission}"), 10, name);
  overrides.channel = folder + channel;
}

/// The same as bringup/demo says.
void set_as_demo(const Mission& mission, deployment::Overrides& overrides) {
  const std::string config = overrides.share + "/config/";
  const std::string file = mission.b ? "mission_b.yaml" : "mission_a.yaml";
  overrides.set.push_back("mission_control.mission_file=" + config + "missions/" + file);
  overrides.channel =
      config + (mission.b ? "radio/classroom_mission_b.yaml" : "radio/classroom.yaml");
}

deployment::Overrides overrides_of(const Mission& mission) {
  deployment::Overrides overrides;
  overrides.share = share();
  (mission.demo ? set_as_demo : set_as_thesis)(mission, overrides);
  overrides.set.push_back("transmission_controller.policy=" + mission.policy);
  overrides.without = {"gcs/view", "uxv/recorder", "gcs/recorder"};
  overrides.seed = mission.seed;
  return overrides;
}

}  // namespace

MissionTraffic record_mission(const Mission& mission) {
  deployment::Overrides overrides = overrides_of(mission);
  const fs::path run_dir =
      fs::temp_directory_path() / ("link_router_bench_" + std::to_string(::getpid()));
  fs::create_directories(run_dir);
  overrides.run_dir = run_dir.string();
  MissionTraffic traffic;
  traffic.channel = radio::load_channel(overrides.channel);
  traffic.walls = geometry::load_walls(overrides.share + "/config/maps/classroom.walls.yaml");
  Recorder recorder(traffic);
  simulation::WorldOptions options;
  options.digest = false;
  options.observer = &recorder;
  options.ends_with_mission = true;
  simulation::SimWorld world(load_deployment(overrides.share + "/bringup/mission.yaml", overrides),
                             options);
  const auto outcome = world.run(seconds(mission.duration_s));
  fs::remove_all(run_dir);
  traffic.begin = traffic.places.front().time;
  traffic.end = traffic.begin + outcome.simulated;
  return traffic;
}

}  // namespace tocsin::bench
