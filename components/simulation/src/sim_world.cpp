// SPDX-License-Identifier: Apache-2.0
#include "simulation/sim_world.hpp"

#include <algorithm>
#include <filesystem>
#include <list>
#include <utility>

#include "foundation/error.hpp"
#include "radio_channel/channel_files.hpp"
#include "runtime/middleware/component_library.hpp"
#include "runtime/middleware/gate_component.hpp"
#include "scheduler.hpp"
#include "sim_devices.hpp"
#include "sim_host.hpp"

namespace tocsin::simulation {
namespace {

constexpr Duration position_period = std::chrono::milliseconds(100);  // of kobuki_simulator

/// Without a radio the sides are joined by a wire.
radio::ChannelParams channel_of(const deployment::Deployment& deployment) {
  if (deployment.radio) return radio::load_channel(deployment.radio->channel);
  radio::ChannelParams wire;
  wire.mode = "bernoulli";
  wire.loss = 0;
  wire.delay_s = 0.0001;
  return wire;
}

std::vector<radio::Wall> walls_of(const deployment::Deployment& deployment) {
  if (!deployment.radio || deployment.radio->walls.empty()) return {};
  return radio::load_walls(deployment.radio->walls);
}

Core core_of(const WorldOptions& options) {
  Core core;
  core.digest_wanted = options.digest;
  core.observer = options.observer;
  return core;
}

bool is_base(const deployment::Program& program) {
  return std::filesystem::path(program.command.front()).filename() == "kobuki_simulator";
}

}  // namespace

struct SimWorld::Parts {
  /// Everything of one host. Components are destroyed before the devices that they use.
  struct Side {
    std::unique_ptr<SimHost> host;
    std::unique_ptr<SimDevices> devices;
    std::list<SimBase> bases;
  };
  struct Process {
    std::string path;  ///< host/name
    std::optional<int> exit_code;
  };
  struct Instance {
    Context context;
    std::unique_ptr<Component> component;
  };

  Parts(deployment::Deployment its, const WorldOptions& wanted);
  ~Parts() {
    while (!instances.empty()) instances.pop_back();
  }
  [[nodiscard]] bool wanted(const deployment::ComponentInstance& one) const;
  [[nodiscard]] std::ptrdiff_t wanted_of(const deployment::Container& container) const;
  void add(const deployment::Host& host);
  void add_bases(const deployment::Host& host, Side& side);
  void add(const deployment::Container& container, Side& side);
  Instance& add_instance(const std::string& name, SimProcess& bus, Side& side, Process& process);
  void start(Instance& instance, const Process& process);
  void feed_position(const std::string& host, const SimBase& base);
  [[nodiscard]] Time next() const;
  [[nodiscard]] bool over() const { return exit_code && options.ends_with_mission; }
  void step(Time now);

  deployment::Deployment deployment;
  WorldOptions options;
  Core core;
  RadioLink link;
  Network network;
  Scheduler scheduler;
  std::list<Side> sides;
  std::list<Process> processes;
  std::list<Instance> instances;
  std::optional<int> exit_code;
};

SimWorld::Parts::Parts(deployment::Deployment its, const WorldOptions& wanted)
    : deployment(std::move(its)),
      options(wanted),
      core(core_of(wanted)),
      link(core, channel_of(deployment), walls_of(deployment),
           static_cast<std::uint64_t>(deployment.seed)),
      network{core, link, QosProfiles(deployment.qos), {}} {
  if (core.observer != nullptr) {
    scheduler.set_on_failure([this](const std::string& component, const char* what, Time now) {
      core.observer->on_failure(component, what, now);
    });
  }
  for (const deployment::Host& host : deployment.hosts) add(host);
}

void SimWorld::Parts::add(const deployment::Host& host) {
  Side& side = sides.emplace_back();
  side.host = std::make_unique<SimHost>(network, host.name, host.role, deployment.traffic);
  side.devices =
      std::make_unique<SimDevices>(core, link, SimDevices::Place{host.name, side.host->direction()},
                                   deployment.run_dir + "/wireless");
  for (const deployment::Host& other : deployment.hosts) {
    if (&other != &host) side.devices->add_peer(other.address);
  }
  add_bases(host, side);
  for (const deployment::Container& container : host.containers) {
    if (container.components.empty() || wanted_of(container) > 0) add(container, side);
  }
}

std::ptrdiff_t SimWorld::Parts::wanted_of(const deployment::Container& container) const {
  return std::count_if(container.components.begin(), container.components.end(),
                       [this](const auto& one) { return wanted(one); });
}

bool SimWorld::Parts::wanted(const deployment::ComponentInstance& one) const {
  const auto& without = options.without;
  return std::find(without.begin(), without.end(), one.component) == without.end();
}

void SimWorld::Parts::add_bases(const deployment::Host& host, Side& side) {
  for (const deployment::Program& program : host.programs) {
    if (!is_base(program)) {
      throw ConfigError(host.name + "/" + program.name + ": the program " +
                        program.command.front() + " has no model; leave it out with --without");
    }
    SimBase& base = side.bases.emplace_back(core, read_base_options(program));
    side.devices->add_base(base);
    feed_position(host.name, base);
  }
}

void SimWorld::Parts::add(const deployment::Container& container, Side& side) {
  SimProcess& bus = side.host->add_process(container.name);
  Process& process = processes.emplace_back(Process{side.host->name() + "/" + container.name, {}});
  for (const deployment::ComponentInstance& one : container.components) {
    if (!wanted(one)) continue;
    Instance& instance = add_instance(one.name, bus, side, process);
    const ComponentEntry& entry = load_component(one.component);
    instance.component = entry.create(instance.context, *one.parameters, deployment.file);
    // What is for a person's eyes only is not ticked; that it reads costs packets all the same.
    if (!container.terminal) start(instance, process);
  }
  Instance& gate = add_instance("gate", bus, side, process);
  gate.component =
      std::make_unique<GateComponent>(gate.context, GateComponent::Params{}, container.name);
  start(gate, process);
}

SimWorld::Parts::Instance& SimWorld::Parts::add_instance(const std::string& name, SimProcess& bus,
                                                         Side& side, Process& process) {
  const auto request_exit = [this, &process](int code) {
    process.exit_code = code;
    if (process.path == deployment.stop_when_exits) exit_code = code;
  };
  instances.push_back(
      {{bus, name, side.host->role(), deployment.run_dir, request_exit, side.devices.get()},
       nullptr});
  return instances.back();
}

void SimWorld::Parts::start(Instance& instance, const Process& process) {
  scheduler.add(*instance.component, [&process] { return !process.exit_code; });
}

void SimWorld::Parts::feed_position(const std::string& host, const SimBase& base) {
  const kobuki::Pose& pose = base.model().pose();
  link.set_position(pose.x_m, pose.y_m);
  if (core.observer != nullptr) {
    const kobuki::BodyVelocity& velocity = base.model().velocity();
    core.observer->on_position({host, core.now, pose.x_m, pose.y_m, pose.heading_rad,
                                velocity.linear_mps, velocity.angular_rad_s});
  }
  core.events.at(core.now + position_period, [this, &host, &base] { feed_position(host, base); });
}

Time SimWorld::Parts::next() const {
  Time next = std::min({core.events.next(), link.next_event(), scheduler.next()});
  for (const Side& side : sides) {
    for (const SimBase& base : side.bases) next = std::min(next, base.next_event());
  }
  return std::max(next, core.now);
}

void SimWorld::Parts::step(Time now) {
  core.now = now;
  core.events.run(now);
  for (Side& side : sides) {
    for (SimBase& base : side.bases) base.advance();
  }
  link.advance();
  if (core.input || scheduler.next() <= now) scheduler.run(now);
  core.input = false;
  if (core.observer != nullptr) core.observer->on_step(now);
}

SimWorld::SimWorld(deployment::Deployment deployment, const WorldOptions& options)
    : parts_(std::make_unique<Parts>(std::move(deployment), options)) {}

SimWorld::~SimWorld() = default;

Outcome SimWorld::run(Duration limit) {
  Parts& all = *parts_;
  const Time begin = all.core.now;
  const Time end = limit > never - begin ? never : begin + limit;
  all.step(begin);
  for (Time next = all.next(); next <= end && !all.over(); next = all.next()) all.step(next);
  if (!all.over()) all.core.now = end;
  return {all.core.now - begin,  all.exit_code,
          all.core.samples,      all.link.pushed(),
          all.scheduler.ticks(), all.core.digest_wanted ? all.core.digest.value() : 0};
}

}  // namespace tocsin::simulation
