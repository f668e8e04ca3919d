// SPDX-License-Identifier: Apache-2.0
#include "world.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/file_cache.hpp"
#include "geometry/wall_file.hpp"
#include "radio_channel/channel_files.hpp"
#include "runtime/middleware/component_library.hpp"

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

std::vector<geometry::Wall> walls_of(const deployment::Deployment& deployment) {
  if (!deployment.radio || deployment.radio->walls.empty()) return {};
  return geometry::load_walls(deployment.radio->walls);
}

QosProfiles qos_of(const deployment::Deployment& deployment) {
  static FileCache<QosProfiles> known;
  return known.get(deployment.qos, [&] { return QosProfiles(deployment.qos); });
}

Core core_of(const WorldOptions& options, std::size_t vehicles) {
  Core core;
  core.digest_wanted = options.digest;
  core.observers = options.observers;
  if (core.observers.empty()) core.observers.assign(vehicles, options.observer);
  return core;
}

std::chrono::system_clock::time_point wall_time(Time now) {
  return std::chrono::system_clock::time_point(std::chrono::nanoseconds(Core::wall_ns(now)));
}

/// Those of a deployment; of one without `vehicles`, which has one, 1.
std::size_t vehicles_of(const deployment::Deployment& deployment) {
  return std::max<std::size_t>(1, deployment.vehicles.size());
}

deployment::Deployment without_relay(deployment::Deployment deployment) {
  if (!deployment.relay) return deployment;
  throw ConfigError(deployment.file +
                    ": a relay is a wire, and not simulated: tocsin launch does it; tocsin sim "
                    "runs the file of its site");
}

RadioLink::Site site_of(const deployment::Deployment& deployment) {
  return {walls_of(deployment), static_cast<std::uint64_t>(deployment.seed),
          vehicles_of(deployment)};
}

bool is_base(const deployment::Program& program) {
  return std::filesystem::path(program.command.front()).filename() == "kobuki_simulator";
}

}  // namespace

World::World(deployment::Deployment deployment, const WorldOptions& options)
    : core(core_of(options, vehicles_of(deployment))),
      log_clock([this] { return wall_time(core.now); }),
      deployment_(without_relay(std::move(deployment))),
      parts_(parts_of(deployment_)),
      options_(options),
      link_(core, channel_of(deployment_), site_of(deployment_)) {
  add_second_link();
  const LogClock::Use use(log_clock);
  scheduler_.set_on_failure([this](const std::string& component, const char* what, Time now) {
    for (Observer* const one : core.observers) {
      if (one != nullptr) one->on_failure(component, what, now);
    }
  });
  for (std::size_t i = 0; i < parts_.size(); ++i) add(parts_[i], i);
  if (!deployment_.vehicles.empty()) add_common();
  plan_faults();
}

void World::add_second_link() {
  if (!deployment_.radio || deployment_.radio->second.empty()) return;
  second_link_.emplace(core, radio::load_channel(deployment_.radio->second), site_of(deployment_),
                       RadioLink::Reports::no);
}

World::~World() {
  const LogClock::Use use(log_clock);
  core.observers.assign(core.observers.size(), nullptr);  // they need not see the end
  fill_disk(false);
  while (!processes_.empty()) {
    auto& instances = processes_.back().instances;
    while (!instances.empty()) instances.pop_back();
    processes_.pop_back();
  }
}

/// A vehicle and what of the station serves it.
void World::add(const deployment::Deployment& part, std::size_t vehicle) {
  Network& network = networks_.emplace_back(Network{core, link_, qos_of(part)});
  network.vehicle = vehicle;
  if (second_link_) network.second_link = &*second_link_;
  if (!deployment_.vehicles.empty()) std::filesystem::create_directories(part.run_dir);
  for (const deployment::Host& host : part.hosts) add(part, host, network);
}

void World::add(const deployment::Deployment& part, const deployment::Host& host,
                Network& network) {
  Side& side = sides_.emplace_back();
  side.vehicle = network.vehicle;
  side.run_dir = folder_of(part, host);
  if (side.run_dir != part.run_dir) std::filesystem::create_directories(side.run_dir);
  side.host = std::make_unique<SimHost>(
      network, host.name, host.role, part.traffic,
      drives_a_vehicle(deployment_) ? VehicleChain::ours : VehicleChain::foreign);
  side.host->set_sites(host.sites);
  side.computer = std::make_unique<SimComputer>(
      core, link_, SimComputer::Place{host.name, side.host->direction(), network.vehicle},
      part.run_dir + "/wireless");
  if (!options_.faults.empty()) side.computer->keeps_files = true;
  for (const deployment::Host& other : part.hosts) {
    if (&other != &host) side.computer->add_peer(other.address);
  }
  add_bases(host, side);
  const bool serves_all = common_ && &network == &*common_;
  for (const deployment::Container& container : host.containers) {
    const bool is_common = deployment::vehicle_of(deployment_, host, container).empty();
    if (deployment_.vehicles.empty() || is_common == serves_all) add(container, side);
  }
}

/// What at the station serves all vehicles, without a link.
void World::add_common() {
  common_.emplace(Network{core, link_, qos_of(deployment_)});
  common_part_ = deployment_;
  common_part_.hosts.clear();
  for (deployment::Host host : deployment_.hosts) {
    auto& containers = host.containers;
    const auto is_of_one = [&](const deployment::Container& one) {
      return !deployment::vehicle_of(deployment_, host, one).empty();
    };
    containers.erase(std::remove_if(containers.begin(), containers.end(), is_of_one),
                     containers.end());
    if (!containers.empty()) common_part_.hosts.push_back(std::move(host));
  }
  for (const Side& side : sides_) {
    common_->homes[{side.host->name(), deployment_.vehicles[side.vehicle]}] = side.host.get();
  }
  for (const deployment::Host& host : common_part_.hosts) add(common_part_, host, *common_);
}

bool World::wanted(const deployment::ComponentInstance& one) const {
  const auto& without = options_.without;
  return std::find(without.begin(), without.end(), one.component) == without.end();
}

void World::add_bases(const deployment::Host& host, Side& side) {
  for (const deployment::Program& program : host.programs) {
    if (!is_base(program)) {
      throw ConfigError(host.name + "/" + program.name + ": the program " +
                        program.command.front() + " has no model; leave it out with --without");
    }
    SimBase& base = side.bases.emplace_back(core, read_base_options(program));
    side.computer->add_base(base);
    feed_position(side, base);
  }
}

void World::add(const deployment::Container& container, Side& side) {
  const auto& components = container.components;
  const bool any = std::any_of(components.begin(), components.end(),
                               [this](const auto& one) { return wanted(one); });
  if (!any && !components.empty()) return;
  processes_.push_back(
      {side.host->name() + "/" + container.name, &container, &side, nullptr, 0, false, {}, {}});
  start(processes_.back());
}

void World::start(Process& process) {
  process.bus = &process.side->host->add_process(process.container->name, process.lives++);
  for (const deployment::ComponentInstance& one : process.container->components) {
    if (!wanted(one)) continue;
    Instance& instance = add_instance(one.name, process);
    const ComponentEntry& entry = load_component(one.component);
    instance.component = entry.create(instance.context, *one.parameters, deployment_.sources);
    if (process.container->terminal) {
      // What is for a person's eyes only is not ticked; that it reads costs packets all the same.
      instance.component->listen(false);
    } else {
      schedule(instance, process);
    }
  }
}

World::Instance& World::add_instance(const std::string& name, Process& process) {
  const SimHost& host = *process.side->host;
  process.instances.push_back(
      {Context(*process.bus, name, host.role())
           .with_run_dir(process.side->run_dir)
           .with_request_exit([this, &process](int code) { exit(process, code); })
           .with_computer(*process.side->computer)
           .with_seed(process_seed(deployment_.seed, host.name(), process.container->name)),
       nullptr});
  return process.instances.back();
}

void World::schedule(Instance& instance, const Process& process) {
  scheduler_.add(
      *instance.component, [&process] { return !process.exit_code; }, core.now);
}

void World::exit(Process& process, int code) {
  process.exit_code = code;
  const auto& last = deployment_.stop_when_exits;
  if (std::find(last.begin(), last.end(), process.path) != last.end()) {
    exit_codes_[process.path] = code;
  }
  tell(process, ProcessEvent::exited);
}

std::optional<int> World::exit_code() const {
  if (exit_codes_.empty() || exit_codes_.size() < deployment_.stop_when_exits.size()) return {};
  int highest = 0;
  for (const auto& one : exit_codes_) highest = std::max(highest, one.second);
  return highest;
}

void World::tell(const Process& process, ProcessEvent event) const {
  Observer* const observer = core.observer(process.side->vehicle);
  if (observer == nullptr) return;
  observer->on_process({process.path, event, core.now, process.exit_code.value_or(0)});
}

void World::feed_position(const Side& side, const SimBase& base) {
  const geometry::Pose& pose = base.model().pose();
  link_.set_position(pose.x_m, pose.y_m, side.vehicle);
  if (second_link_) second_link_->set_position(pose.x_m, pose.y_m, side.vehicle);
  if (Observer* const observer = core.observer(side.vehicle)) {
    const geometry::Twist& velocity = base.model().velocity();
    observer->on_position({side.host->name(), core.now, pose.x_m, pose.y_m, pose.heading_rad,
                           velocity.linear_mps, velocity.angular_rad_s, base.commanded(),
                           base.model().outputs().control.speed_mm_s == 0});
  }
  core.events.at(core.now + position_period, [this, &side, &base] { feed_position(side, base); });
}

Time World::next() {
  off_air_ = std::min(core.events.next(), scheduler_.next());
  for (const Side& side : sides_) {
    for (const SimBase& base : side.bases) off_air_ = std::min(off_air_, base.next_event());
  }
  // The first link may run ahead of the others to where its next packet arrives, not of the second.
  if (second_link_) off_air_ = std::min(off_air_, second_link_->next_event());
  return std::max(link_.next_arrival(off_air_), core.now);
}

void World::step(Time now) {
  core.now = now;
  if (off_air_ <= now) {
    core.events.run(now);
    for (Side& side : sides_) {
      for (SimBase& base : side.bases) base.advance();
    }
  }
  link_.advance();
  if (second_link_) second_link_->advance();
  if (scheduler_.next() <= now) scheduler_.run(now);
  for (Observer* const one : core.observers) {
    if (one != nullptr) one->on_step(now);
  }
}

Outcome World::outcome(Time begin) const {
  return {core.now - begin,
          exit_code(),
          exit_codes_,
          core.samples,
          link_.pushed(),
          scheduler_.ticks(),
          core.digest_wanted ? core.digest.value() : 0};
}

}  // namespace tocsin::simulation
