// SPDX-License-Identifier: Apache-2.0
#include "simulation/faults.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <random>

#include "foundation/error.hpp"
#include "foundation/names.hpp"
#include "foundation/parameters.hpp"
#include "foundation/yaml_file.hpp"

namespace tocsin::simulation {
namespace {

constexpr std::array names{"crash",      "loss",           "delay",        "duplication",
                           "clock_jump", "serial_noise",   "unplug",       "disk_full",
                           "stop",       "rogue_velocity", "freeze",       "forge",
                           "laser_dead", "laser_stuck",    "laser_late",   "laser_covered",
                           "slip",       "kidnap",         "access_point", "pose_stuck"};
/// The first of them are drawn from one sequence of numbers.
constexpr std::size_t drawn_together = 8;
/// From one vehicle to the next.
constexpr std::uint64_t seed_step = 1'000'003;

/// A fault as in the file.
struct FaultEntry {
  std::string kind = "loss";
  double at_s = 0;
  double for_s = 1;
  std::string target;
  double amount = 0;
  template <class Visitor>
  void visit(Visitor& v) {
    v("kind", kind, {"crash",         "loss",   "delay",      "duplication",  "clock_jump",
                     "serial_noise",  "unplug", "disk_full",  "stop",         "rogue_velocity",
                     "freeze",        "forge",  "laser_dead", "laser_stuck",  "laser_late",
                     "laser_covered", "slip",   "kidnap",     "access_point", "pose_stuck"},
      "what goes wrong");
    v("at_s", at_s, {0, 1e6}, "[s] from the start of the run");
    v("for_s", for_s, {0.001, 1e6}, "[s] how long; of a crash: until it is started again");
    v("target", target,
      "crash and freeze: host/process; clock_jump: host; else of several vehicles one");
    v("amount", amount, {-1e6, 1e6},
      "share, [s] of delay, clock_jump and laser_late, or [m] of kidnap and access_point");
  }
};

void check(const Fault& fault, const std::string& path) {
  const bool is_share = fault.kind == FaultKind::loss || fault.kind == FaultKind::duplication ||
                        fault.kind == FaultKind::serial_noise || fault.kind == FaultKind::slip;
  if (is_share && (fault.amount < 0 || fault.amount > 1)) {
    throw ConfigError(path + ": faults.amount: " + std::to_string(fault.amount) +
                      " is outside [0, 1]");
  }
  const auto words = words_of_path(fault.target);
  if (!std::all_of(words.begin(), words.end(), is_name)) {
    throw ConfigError(path + ": faults.target: '" + fault.target + "' is not host or host/process");
  }
  const bool is_magnitude = fault.kind == FaultKind::delay || fault.kind == FaultKind::laser_late ||
                            fault.kind == FaultKind::kidnap;
  if (is_magnitude && fault.amount < 0) {
    throw ConfigError(path + ": faults.amount: a delay or a distance is not negative");
  }
}

bool earlier(const Fault& a, const Fault& b) { return a.at_s < b.at_s; }

/// Numbers from the seed, the same with every standard library.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : random_(seed * 0x9E3779B97F4A7C15ULL + 1) {}
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }
  double between(double low, double high) {
    const double share = static_cast<double>(random_() >> 11U) / 9007199254740992.0;  // 2^53
    return std::round((low + (high - low) * share) * 1000) / 1000;
  }

 private:
  std::mt19937_64 random_;
};

template <class Wanted>
std::vector<std::string> processes_of(const deployment::Deployment& deployment, Wanted wanted) {
  std::vector<std::string> all;
  for (const deployment::Host& host : deployment.hosts) {
    for (const deployment::Container& container : host.containers) {
      if (wanted(container)) all.push_back(host.name + "/" + container.name);
    }
  }
  return all;
}

bool has(const deployment::Container& container, const char* component) {
  const auto& components = container.components;
  return std::any_of(components.begin(), components.end(),
                     [component](const auto& one) { return one.component == component; });
}

/// Paths of the processes that have such a component.
std::vector<std::string> processes_with(const char* component,
                                        const deployment::Deployment& deployment) {
  return processes_of(
      deployment, [component](const deployment::Container& one) { return has(one, component); });
}

bool has_laser(const deployment::Host& host) {
  return std::any_of(host.programs.begin(), host.programs.end(), [](const auto& program) {
    const auto& words = program.command;
    return std::find(words.begin(), words.end(), "--laser") != words.end();
  });
}

Fault draw_fault(Draw& draw, const deployment::Deployment& deployment) {
  const auto processes =
      processes_of(deployment, [](const deployment::Container& one) { return !one.terminal; });
  Fault fault;
  fault.kind = static_cast<FaultKind>(draw.below(drawn_together));
  if (draw.below(3) == 0) fault.kind = FaultKind::crash;  // what hurts most comes most often
  if (fault.kind == FaultKind::crash && processes.empty()) fault.kind = FaultKind::loss;
  fault.at_s = draw.between(2, 60);
  fault.for_s = draw.between(0.2, 10);
  fault.amount = draw.between(0.02, 1);
  if (fault.kind == FaultKind::crash) {
    fault.target = processes[draw.below(processes.size())];
    fault.for_s = draw.between(0.2, 5);
    fault.amount = 0;
  }
  if (fault.kind == FaultKind::clock_jump) {
    fault.target = deployment.hosts[draw.below(deployment.hosts.size())].name;
    fault.amount = draw.between(-3600, 3600);
  }
  if (fault.kind == FaultKind::serial_noise) fault.amount = draw.between(0.0001, 0.05);
  return fault;
}

/// Numbers for one kind of faults alone.
Draw draw_of(FaultKind kind, std::uint64_t seed) {
  return Draw(seed + (static_cast<std::uint64_t>(kind) << 48U));
}

Fault in_the_first_minute(FaultKind kind, Draw& draw) {
  Fault fault;
  fault.kind = kind;
  fault.at_s = draw.between(2, 60);
  fault.for_s = draw.between(0.2, 10);
  return fault;
}

std::optional<Fault> draw_stop(std::uint64_t seed) {
  Draw draw = draw_of(FaultKind::stop, seed);
  if (draw.below(2) == 0) return std::nullopt;
  return in_the_first_minute(FaultKind::stop, draw);
}

/// While the stop stands, and somewhat longer: nobody promises to hold back others without one.
std::optional<Fault> draw_rogue_velocity(std::uint64_t seed, const Fault& stop) {
  Draw draw = draw_of(FaultKind::rogue_velocity, seed);
  if (draw.below(2) == 0) return std::nullopt;
  Fault fault;
  fault.kind = FaultKind::rogue_velocity;
  fault.at_s = stop.at_s + draw.between(0, stop.for_s);
  fault.for_s = draw.between(0.2, 5);
  return fault;
}

std::optional<Fault> draw_freeze(std::uint64_t seed, const deployment::Deployment& deployment) {
  Draw draw = draw_of(FaultKind::freeze, seed);
  const auto routers = processes_with("link_router", deployment);
  if (draw.below(3) != 0 || routers.empty()) return std::nullopt;
  Fault fault = in_the_first_minute(FaultKind::freeze, draw);
  fault.target = routers[draw.below(routers.size())];
  return fault;
}

std::optional<Fault> draw_forge(std::uint64_t seed) {
  Draw draw = draw_of(FaultKind::forge, seed);
  if (draw.below(4) != 0) return std::nullopt;
  return in_the_first_minute(FaultKind::forge, draw);
}

std::optional<Fault> draw_laser_fault(std::uint64_t seed,
                                      const deployment::Deployment& deployment) {
  Draw draw = draw_of(FaultKind::laser_dead, seed);
  const auto& hosts = deployment.hosts;
  if (draw.below(2) != 0 || !std::any_of(hosts.begin(), hosts.end(), has_laser))
    return std::nullopt;
  constexpr std::array kinds{FaultKind::laser_dead, FaultKind::laser_stuck, FaultKind::laser_late,
                             FaultKind::laser_covered};
  Fault fault = in_the_first_minute(kinds[draw.below(kinds.size())], draw);
  if (fault.kind == FaultKind::laser_late) fault.amount = draw.between(0.3, 1.1);
  return fault;
}

/// What only a vehicle that looks where it is can bear.
void draw_displacements(std::uint64_t seed, const deployment::Deployment& deployment,
                        FaultPlan& plan) {
  if (processes_with("localiser", deployment).empty()) return;
  Draw slip = draw_of(FaultKind::slip, seed);
  if (slip.below(3) == 0) {
    plan.push_back(in_the_first_minute(FaultKind::slip, slip));
    plan.back().amount = slip.between(0.1, 1);
  }
  Draw kidnap = draw_of(FaultKind::kidnap, seed);
  if (kidnap.below(4) == 0) {
    plan.push_back(in_the_first_minute(FaultKind::kidnap, kidnap));
    plan.back().amount = kidnap.between(1, 5);
  }
}

/// What makes a map of the link wrong.
void draw_surprises(std::uint64_t seed, const deployment::Deployment& deployment, FaultPlan& plan) {
  Draw moved = draw_of(FaultKind::access_point, seed);
  if (!processes_with("link_mapper", deployment).empty() && moved.below(3) == 0) {
    plan.push_back(in_the_first_minute(FaultKind::access_point, moved));
    plan.back().amount = moved.between(2, 8) * (moved.below(2) == 0 ? 1 : -1);
  }
  Draw stuck = draw_of(FaultKind::pose_stuck, seed);
  if (!processes_with("modelled_localiser", deployment).empty() && stuck.below(3) == 0) {
    plan.push_back(in_the_first_minute(FaultKind::pose_stuck, stuck));
  }
}

FaultPlan draw_all(std::uint64_t seed, const deployment::Deployment& deployment) {
  Draw draw(seed);
  FaultPlan plan(1 + draw.below(6));
  for (Fault& fault : plan) fault = draw_fault(draw, deployment);
  if (const auto stop = draw_stop(seed)) {
    plan.push_back(*stop);
    if (const auto rogue = draw_rogue_velocity(seed, *stop)) plan.push_back(*rogue);
  }
  if (const auto freeze = draw_freeze(seed, deployment)) plan.push_back(*freeze);
  if (const auto forge = draw_forge(seed)) plan.push_back(*forge);
  if (const auto laser = draw_laser_fault(seed, deployment)) plan.push_back(*laser);
  draw_displacements(seed, deployment, plan);
  draw_surprises(seed, deployment, plan);
  return plan;
}

}  // namespace

FaultPlan random_faults(std::uint64_t seed, const deployment::Deployment& deployment) {
  FaultPlan plan;
  const auto parts = parts_of(deployment);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    for (Fault fault : draw_all(seed + i * seed_step, parts[i])) {
      const bool is_of_site =
          fault.kind == FaultKind::disk_full || fault.kind == FaultKind::access_point;
      if (!deployment.vehicles.empty() && fault.target.empty() && !is_of_site) {
        fault.target = deployment.vehicles[i];
      }
      plan.push_back(std::move(fault));
    }
  }
  std::sort(plan.begin(), plan.end(), earlier);
  return plan;
}

FaultPlan load_faults(const std::string& path) {
  const YAML::Node file = read_yaml_file(path);
  const YAML::Node list = file.IsMap() ? file["faults"] : YAML::Node();
  if (!list.IsDefined() || !list.IsSequence()) throw ConfigError(path + ": has no list `faults`");
  FaultPlan plan;
  for (const YAML::Node& node : list) {
    const auto entry = load_parameters<FaultEntry>(node, "faults", path);
    const auto at = std::find(names.begin(), names.end(), entry.kind) - names.begin();
    plan.push_back(
        {static_cast<FaultKind>(at), entry.at_s, entry.for_s, entry.target, entry.amount});
    check(plan.back(), path);
  }
  std::stable_sort(plan.begin(), plan.end(), earlier);
  return plan;
}

std::string to_yaml(const FaultPlan& plan) {
  std::string text = "faults:\n";
  for (const Fault& fault : plan) {
    char line[200];
    std::snprintf(line, sizeof line,
                  "  - {kind: %s, at_s: %g, for_s: %g, target: \"%s\", amount: %g}\n",
                  names[static_cast<std::size_t>(fault.kind)], fault.at_s, fault.for_s,
                  fault.target.c_str(), fault.amount);
    text += line;
  }
  return text;
}

double end_of(const FaultPlan& plan) {
  double end_s = 0;
  for (const Fault& fault : plan) end_s = std::max(end_s, fault.at_s + fault.for_s);
  return end_s;
}

}  // namespace tocsin::simulation
