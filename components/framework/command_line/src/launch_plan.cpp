// SPDX-License-Identifier: Apache-2.0
#include "command_line/launch_plan.hpp"

#include <algorithm>
#include <cassert>

#include "foundation/error.hpp"

namespace tocsin {
namespace {

std::string located(const std::string& process, const std::string& program,
                    const Folders& folders) {
  if (const auto found = find_program(program, folders)) return found->string();
  throw ConfigError(process + ": program '" + program +
                    "' is not found beside tocsin-launch, in its install folder or in $PATH");
}

}  // namespace

std::vector<ProcessSpec> plan_processes(const deployment::Deployment& deployment,
                                        const ResolvedFile& file, const Folders& folders) {
  std::vector<ProcessSpec> specs;
  std::size_t index = 0;
  for (const deployment::Host& host : deployment.hosts) {
    for (const deployment::Program& program : host.programs) {
      ProcessSpec spec{host.name + "/" + program.name, program.command, index, false, false};
      spec.checks_itself = program.command.front() == "kobuki_simulator";
      spec.command[0] = located(spec.name, spec.command[0], folders);
      specs.push_back(std::move(spec));
    }
    for (const deployment::Container& container : host.containers) {
      const std::string name = host.name + "/" + container.name;
      specs.push_back({name,
                       {located(name, "tocsin-container", folders), file.path, host.name,
                        container.name, file.copy},
                       index,
                       container.terminal,
                       false});
    }
    ++index;
  }
  return specs;
}

namespace {

/// One of two emulated radios.
struct PlannedRadio {
  std::string name;  ///< of the process, and of the files in the folder of the run
  std::string channel;
  std::string interface;
  std::vector<std::string> addresses;  ///< of the hosts, in their order
  std::string wireless;                ///< what a driver tells of it; empty: nothing
};

/// Of several stations the one that link_emulator calls gcs.
const deployment::Host& first_station(const deployment::Deployment& deployment) {
  const deployment::Host* const named = find_host(deployment, to_string(Role::gcs));
  if (named != nullptr && named->role == Role::gcs) return *named;
  return *std::find_if(deployment.hosts.begin(), deployment.hosts.end(),
                       [](const deployment::Host& one) { return one.role == Role::gcs; });
}

/// As link_emulator calls it: several vehicles have names, one is a role.
std::string name_of_end(const deployment::Deployment& deployment, const deployment::Host& host) {
  const bool is_named =
      host.role == Role::uxv ? !deployment.vehicles.empty() : &host != &first_station(deployment);
  return is_named ? host.name : to_string(host.role);
}

ProcessSpec plan_radio(const deployment::Deployment& deployment, const PlannedRadio& radio,
                       const std::vector<int>& descriptors, const Folders& folders) {
  ProcessSpec spec{
      radio.name, {located(radio.name, "link_emulator", folders)}, std::nullopt, false, true};
  const auto add = [&](const std::string& option, const std::string& value) {
    spec.command.push_back(option);
    spec.command.push_back(value);
  };
  add("--channel", radio.channel);
  add("--walls", deployment.radio->walls);
  add("--seed", std::to_string(deployment.seed));
  add("--interface", radio.interface);
  for (std::size_t i = 0; i < descriptors.size(); ++i) {
    const deployment::Host& host = deployment.hosts[i];
    const bool is_site = host.role == Role::gcs && &host != &first_station(deployment);
    add(is_site ? "--site" : "--end", name_of_end(deployment, host) + ":/proc/self/fd/" +
                                          std::to_string(descriptors[i]) + ":" +
                                          radio.addresses[i] + "/24");
  }
  const std::string folder =
      deployment.run_dir + (deployment.vehicles.empty() ? "/" : "/{vehicle}/");
  add("--control", folder + radio.name + ".sock");
  add("--stats", folder + radio.name + ".jsonl");
  if (!radio.wireless.empty()) add("--wireless", folder + radio.wireless);
  return spec;
}

}  // namespace

std::vector<ProcessSpec> plan_radios(const deployment::Deployment& deployment,
                                     const std::vector<int>& descriptors, const Folders& folders) {
  assert(deployment.radio && descriptors.size() == deployment.hosts.size());
  PlannedRadio first{"radio", deployment.radio->channel, "wlan0", {}, "wireless"};
  PlannedRadio second{"second_radio", deployment.radio->second, "wwan0", {}, ""};
  for (const deployment::Host& host : deployment.hosts) {
    first.addresses.push_back(host.address);
    if (host.second) second.addresses.push_back(host.second->address);
  }
  std::vector<ProcessSpec> specs{plan_radio(deployment, first, descriptors, folders)};
  if (!second.channel.empty()) {
    specs.push_back(plan_radio(deployment, second, descriptors, folders));
  }
  return specs;
}

}  // namespace tocsin
