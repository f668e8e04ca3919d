// SPDX-License-Identifier: Apache-2.0
#include "sim_host.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/file_cache.hpp"
#include "sim_link_bus.hpp"

namespace tocsin::simulation {
namespace {

TrafficRules rules_of(const std::string& file, Role role, VehicleChain chain) {
  static std::map<std::pair<Role, VehicleChain>, FileCache<TrafficRules>> known;
  static std::mutex mutex;
  std::unique_lock<std::mutex> lock(mutex);
  auto& of_side = known[{role, chain}];
  lock.unlock();
  return of_side.get(file, [&] { return TrafficRules(file, role, chain); });
}

}  // namespace

SimLinkBus* Network::find_router(PeerId life) const {
  for (const auto& entry : routers) {
    if (entry.second->self() == life) return entry.second;
  }
  return nullptr;
}

SimHost::SimHost(Network& network, std::string name, Role role, const std::string& traffic_file,
                 VehicleChain chain)
    : network_(network),
      name_(std::move(name)),
      role_(role),
      rules_(rules_of(traffic_file, role_, chain)) {}

radio::Direction SimHost::direction() const {
  return role_ == Role::uxv ? radio::Direction::uplink : radio::Direction::downlink;
}

SimProcess& SimHost::add_process(const std::string& name, int life) {
  return processes_.emplace_back(network_, *this, name, life);
}

SimHost& SimHost::home_of(const std::string& topic) {
  const auto found = network_.homes.find({name_, topic.substr(0, topic.find('/'))});
  return found == network_.homes.end() ? *this : *found->second;
}

void SimHost::detach(SimProcess::Topic& topic) {
  auto& processes = topic.on_host->processes;
  processes.erase(std::remove(processes.begin(), processes.end(), &topic), processes.end());
  topic.on_host->last.erase(topic.source);  // it died with it
}

void SimHost::attach(SimProcess::Topic& topic) {
  HostTopic& all = topics_[topic.endpoint.topic.name];
  topic.on_host = &all;
  if (all.type == nullptr) all.type = topic.endpoint.type;
  if (all.type != topic.endpoint.type) {
    throw ConfigError(std::string("topic ") + topic.endpoint.topic.name + ": type " +
                      topic.endpoint.type->name + " clashes with " + all.type->name);
  }
  all.processes.push_back(&topic);
  for (const auto& kept : all.last) topic.deliver(kept.second);
  for (const auto& kept : all.last_carried) {
    (void)topic.carried.is_first(kept.second.source, kept.second.sequence);
    topic.deliver(kept.second);
  }
}

void SimHost::set_router(SimLinkBus* router) {
  router_ = router;
  // What it had carried it kept for late readers as a writer of this host, which has died with it.
  for (auto& entry : topics_) entry.second.last_carried.clear();
  if (router == nullptr) return;
  for (const auto& entry : topics_) {
    const HostTopic& all = entry.second;
    for (const SimProcess::Topic* topic : all.processes) {
      if (!topic->writes) continue;
      router->on_writer(*topic);
      if (const Sample* const last = last_of(*topic)) router->on_written(*topic, *last);
    }
  }
}

void SimHost::deliver_carried(const Flow& flow, const CarriedSample& carried,
                              const Freight& freight) {
  if (freight.from == nullptr) return;
  HostTopic& all = topics_[flow.topic];
  Sample sample;
  sample.message = freight.message;
  sample.received = network_.core.now;
  sample.sent_wall_ns = carried.sent_wall_ns;
  sample.received_wall_ns = Core::wall_ns(network_.core.now) + clock_offset_.count();
  sample.sequence = carried.sequence;
  sample.source = carried.source;
  sample.bytes = carried.bytes;
  const auto [writer, is_new] = all.carried.try_emplace(carried.source);
  if (is_new) writer->second = {freight.from->host, flow.user_data};
  if (network_.observer() != nullptr) {
    const GivenAs as = flow.topic == freight.from->topic ? GivenAs::live : GivenAs::backfilled;
    network_.observer()->on_given({*freight.from, name_, network_.core.now, freight.written, as});
  }
  if (flow.transient_local) all.last_carried[freight.from->host + "|" + flow.user_data] = sample;
  for (SimProcess::Topic* topic : all.processes) {
    if (!topic->carried.is_first(sample.source, sample.sequence)) continue;
    if (network_.observer() != nullptr && topic->reads()) {
      network_.observer()->on_delivered({*freight.from, topic->end, carried.sequence,
                                         freight.written, freight.written_at, freight.written_at,
                                         network_.core.now, carried.bytes, freight.message.get()});
    }
    topic->deliver(sample);
  }
}

bool SimHost::has_readers(const SimProcess::Topic& topic) {
  const auto& all = topic.on_host->processes;
  return std::any_of(all.begin(), all.end(), [](const auto* one) { return one->reads(); });
}

const Sample* SimHost::last_of(const SimProcess::Topic& topic) {
  const auto kept = topic.on_host->last.find(topic.source);
  return kept == topic.on_host->last.end() ? nullptr : &kept->second;
}

bool SimHost::reads(const std::string& topic) const {
  const auto found = topics_.find(topic);
  return found != topics_.end() && !found->second.processes.empty() &&
         has_readers(*found->second.processes.front());
}

void SimHost::deliver(const SimProcess::Topic& from, const Sample& sample) {
  if (from.keeps_last) from.on_host->last[from.source] = sample;
  for (SimProcess::Topic* topic : from.on_host->processes) {
    topic->deliver(sample);
  }
}

}  // namespace tocsin::simulation
