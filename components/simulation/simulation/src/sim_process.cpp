// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/hash.hpp"
#include "sim_host.hpp"
#include "sim_link_bus.hpp"

namespace tocsin::simulation {
namespace {

/// Removes the receiver when it is destroyed.
class Attached final : public Subscription {
 public:
  Attached(const SimProcess& process, SimProcess::Topic& topic, Receiver& receiver)
      : process_(process), topic_(topic), receiver_(receiver) {
    topic_.attach(receiver_);
    process_.tell_router(topic_);
  }
  ~Attached() override {
    topic_.detach(receiver_);
    process_.tell_router(topic_);
  }
  [[nodiscard]] std::optional<WriterInfo> writer(std::uint64_t source) const override {
    return process_.writer(topic_, source);
  }

 private:
  const SimProcess& process_;
  SimProcess::Topic& topic_;
  Receiver& receiver_;
};

class OpenWriter final : public Publication {
 public:
  OpenWriter(SimProcess& process, SimProcess::Topic& topic) : process_(process), topic_(topic) {}
  Status write(const std::shared_ptr<const void>& message) override {
    return process_.write(topic_, message);
  }
  [[nodiscard]] bool has_readers() const override {
    return topic_.keeps_last || topic_.end.traffic_class || SimHost::has_readers(topic_);
  }
  [[nodiscard]] bool is_read() const override { return SimHost::has_readers(topic_); }

 private:
  SimProcess& process_;
  SimProcess::Topic& topic_;
};

}  // namespace

SimProcess::Topic::Topic(const Endpoint& its, const QosProfile& profile)
    : endpoint(its), qos(profile), keeps_last(profile.keeps_last()), kept(keeps_last) {}

void SimProcess::Topic::attach(Receiver& receiver) {
  receivers.push_back(&receiver);
  if (keeps_last) kept.attach(receiver);
}

void SimProcess::Topic::detach(Receiver& receiver) {
  receivers.erase(std::remove(receivers.begin(), receivers.end(), &receiver), receivers.end());
  if (keeps_last) kept.detach(receiver);
}

void SimProcess::Topic::deliver(const Sample& sample) {
  if (keeps_last) return kept.deliver(Sample(sample));
  for (Receiver* receiver : receivers) receiver->receive(sample);
}

SimProcess::SimProcess(Network& network, SimHost& host, std::string name, int life)
    : network_(network), host_(host), name_(std::move(name)), life_(life) {}

SimProcess::~SimProcess() = default;

std::unique_ptr<SimProcess::Topic> SimProcess::make_topic(const Endpoint& endpoint) {
  const std::string given = endpoint.topic.name;
  SimHost& home = host_.home_of(given);
  Endpoint at_home = endpoint;
  if (&home != &host_) at_home.topic.name += given.find('/') + 1;
  const std::string name = at_home.topic.name;
  auto made = std::make_unique<Topic>(at_home, network_.qos.of(endpoint.topic.qos, name));
  made->home = &home;
  made->label = host_.name() + "/" + name_ + "/" + given;
  made->source = hash_of(life_ == 0 ? made->label : made->label + "#" + std::to_string(life_));
  made->end.host = host_.name();
  made->end.role = host_.role();
  made->end.process = name_;
  made->end.topic = name;
  made->end.scope = endpoint.topic.scope;
  made->end.type = endpoint.type;
  made->end.lifespan_s = made->qos.lifespan_s;
  made->end.reliable = made->qos.reliable();
  made->end.keeps_one = made->qos.depth == 1;
  return made;
}

SimProcess::Topic& SimProcess::topic(const Endpoint& endpoint) {
  auto known = topics_.find(endpoint.topic.name);
  if (known == topics_.end()) {
    known = topics_.emplace(endpoint.topic.name, make_topic(endpoint)).first;
    known->second->home->attach(*known->second);
  }
  const auto& found = known->second;
  if (found->endpoint.type != endpoint.type) {
    throw ConfigError(std::string("topic ") + endpoint.topic.name + ": type " +
                      endpoint.type->name + " clashes with " + found->endpoint.type->name);
  }
  return *found;
}

std::unique_ptr<Subscription> SimProcess::subscribe(const Endpoint& endpoint, Receiver& receiver) {
  Topic& its = topic(endpoint);
  return std::make_unique<Attached>(*this, its, receiver);
}

void SimProcess::tell_router(const Topic& its) const {
  if (SimLinkBus* const router = its.home->router()) router->on_readers(its.endpoint.topic.name);
}

std::unique_ptr<Publication> SimProcess::advertise(const Endpoint& endpoint) {
  Topic& its = topic(endpoint);
  if (*endpoint.user_data != 0) its.end.user_data = endpoint.user_data;
  if (endpoint.topic.scope == Scope::link) (void)its.home->rules().of(its.endpoint.topic.name);
  begin_to_write(its);
  return std::make_unique<OpenWriter>(*this, its);
}

std::unique_ptr<ServerEnd> SimProcess::serve(const ServiceEndpoint& endpoint,
                                             ServerReceiver& receiver) {
  return host_.services().serve(endpoint, receiver);
}

std::unique_ptr<ClientEnd> SimProcess::call(const ServiceEndpoint& endpoint,
                                            ClientReceiver& receiver) {
  return host_.services().call(endpoint, receiver);
}

void SimProcess::begin_to_write(Topic& its) {
  const TrafficRule* const rule = its.home->rules().find(its.endpoint.topic.name);
  if (rule != nullptr && rule->live && !rule->on_demand) {
    its.end.traffic_class = rule->traffic_class;
    its.end.pausable = rule->while_poor != WhilePoor::send;
    its.end.drops = rule->while_poor == WhilePoor::drop;
    its.end.stored = rule->stored;
    its.end.durable = its.keeps_last;
  }
  if (std::exchange(its.writes, true)) return;
  if (SimLinkBus* const router = its.home->router()) router->on_writer(its);
}

Status SimProcess::write(Topic& its, const std::shared_ptr<const void>& message) {
  Core& core = network_.core;
  if (core.dying) return Status::failed;
  ++core.samples;
  if (core.digest_wanted) {
    core.digest.add_sample(core.now, its.label, *its.endpoint.type, message.get());
  }
  Sample sample;
  sample.message = message;
  sample.received = core.now;
  sample.sent_wall_ns = sample.received_wall_ns = wall_ns(core.now);
  sample.sequence = ++its.written;
  sample.source = its.source;
  SimHost::deliver(its, sample);
  if (SimLinkBus* const router = its.home->router()) router->on_written(its, sample);
  if (its.home->observer() != nullptr) report(its, message.get());
  return Status::ok;
}

std::optional<WriterInfo> SimProcess::writer(const Topic& its, std::uint64_t source) const {
  for (const Topic* one : its.on_host->processes) {
    if (one->source == source) return WriterInfo{host_.name(), one->end.user_data};
  }
  const auto carried = its.on_host->carried.find(source);
  return carried == its.on_host->carried.end() ? std::nullopt : std::optional(carried->second);
}

void SimProcess::report(const Topic& its, const void* message) const {
  const Core& core = network_.core;
  const bool crosses = its.end.traffic_class.has_value();
  const std::size_t bytes = crosses ? its.endpoint.type->serialized_size(message) : 0;
  its.home->observer()->on_written({its.end, core.now, its.written, bytes, message});
}

std::int64_t SimProcess::wall_ns(Time t) const {
  return Core::wall_ns(t) + host_.clock_offset().count();
}

void SimProcess::die() {
  for (const auto& entry : topics_) {
    SimHost::detach(*entry.second);
    if (SimLinkBus* const router = entry.second->home->router()) {
      router->on_writer_gone(*entry.second);
    }
  }
}

std::unique_ptr<LinkBus> SimProcess::open_link(const std::function<void()>& on_event) {
  return std::make_unique<SimLinkBus>(network_, *this, host_, on_event);
}

}  // namespace tocsin::simulation
