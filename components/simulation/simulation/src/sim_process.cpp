// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
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
  }
  ~Attached() override { topic_.detach(receiver_); }
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
    return topic_.gated || topic_.keeps_last || topic_.end.traffic_class ||
           SimHost::has_readers(topic_);
  }

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
  const std::string name = endpoint.topic.name;
  auto made = std::make_unique<Topic>(endpoint, network_.qos.of(endpoint.topic.qos, name));
  made->label = host_.name() + "/" + name_ + "/" + name;
  made->source = hash_of(life_ == 0 ? made->label : made->label + "#" + std::to_string(life_));
  made->end.host = host_.name();
  made->end.role = host_.role();
  made->end.process = name_;
  made->end.topic = name;
  made->end.scope = endpoint.topic.scope;
  made->end.type = endpoint.type;
  made->end.lifespan_s = made->qos.lifespan_s;
  made->end.reliable = made->qos.reliable();
  return made;
}

SimProcess::Topic& SimProcess::topic(const Endpoint& endpoint) {
  auto known = topics_.find(endpoint.topic.name);
  if (known == topics_.end()) {
    known = topics_.emplace(endpoint.topic.name, make_topic(endpoint)).first;
    host_.attach(*known->second);
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
  auto attached = std::make_unique<Attached>(*this, its, receiver);
  const bool crosses = endpoint.topic.scope == Scope::link && !host_.routed();
  if (crosses && !its.reader) make_reader(its);
  return attached;
}

std::unique_ptr<Publication> SimProcess::advertise(const Endpoint& endpoint) {
  Topic& its = topic(endpoint);
  if (*endpoint.user_data != 0) its.end.user_data = endpoint.user_data;
  if (host_.routed()) {
    begin_to_write(its);
  } else if (endpoint.topic.scope == Scope::link && !its.gated) {
    make_writer(its);
  }
  return std::make_unique<OpenWriter>(*this, its);
}

void SimProcess::begin_to_write(Topic& its) {
  const auto& rules = host_.rules().all();
  const auto rule = rules.find(its.endpoint.topic.name);
  if (rule != rules.end()) its.end.traffic_class = rule->second.traffic_class;
  if (std::exchange(its.writes, true)) return;
  if (SimLinkBus* const router = host_.router()) router->on_writer(its);
}

void SimProcess::receive(Topic& its, const Change& change, std::uint64_t source) {
  if (Observer* observer = network_.core.observer) {
    observer->on_delivered({*change.from, its.end, change.sequence, change.written,
                            change.written_at, change.sent, now(), change.bytes,
                            change.message.get()});
  }
  Sample sample;
  sample.message = change.message;
  sample.received = now();
  sample.sent_wall_ns = change.sent_wall_ns;
  sample.received_wall_ns = wall_ns(now());
  sample.sequence = change.sequence;
  sample.source = source;
  sample.bytes = static_cast<std::uint32_t>(change.bytes);
  its.deliver(sample);
}

void SimProcess::make_reader(Topic& its) {
  const auto deliver = [this, &its](const Change& change, std::uint64_t source) {
    receive(its, change, source);
  };
  its.reader = RtpsReader::make(network_.core, network_.link,
                                requested(its.endpoint.topic, its.qos), deliver);
  network_.endpoints.add(its.endpoint.topic.name, host_, *its.reader);
}

/// Null: the writer's samples leave at once.
Pacer* SimProcess::pacer(const QosProfile& qos) {
  if (qos.flow_controller.empty()) return nullptr;
  const FlowController& settings = network_.qos.flow_controllers().at(qos.flow_controller);
  if (settings.max_bytes_per_period == 0) return nullptr;
  auto& found = pacers_[qos.flow_controller];
  if (!found) found = std::make_unique<Pacer>(network_.core, settings);
  return found.get();
}

void SimProcess::make_writer(Topic& its) {
  const TrafficRule& rule = host_.rules().of(its.endpoint.topic.name);
  its.end.traffic_class = rule.traffic_class;
  its.end.pausable = rule.while_poor != WhilePoor::send;
  its.end.drops = rule.while_poor == WhilePoor::drop;
  const RtpsWriter::Owner owner{{host_.direction(), host_.rules().dscp(rule.traffic_class)},
                                its.source,
                                &its.end,
                                &its.origin,
                                [this](Time t) { return wall_ns(t); }};
  auto writer = RtpsWriter::make(network_.core, network_.link, owner, its.qos, pacer(its.qos));
  its.writer = writer.get();
  GatedWriter::Freshness freshness;
  if (std::isfinite(its.qos.lifespan_s)) {
    freshness = {[this] { return now(); }, seconds(its.qos.lifespan_s)};
  }
  its.gated = std::make_unique<GatedWriter>(its.endpoint.topic.name, rule, std::move(writer),
                                            std::move(freshness));
  its.gated->set_open(gate_open_);
  network_.endpoints.add(its.endpoint.topic.name, host_, *its.writer);
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
  if (SimLinkBus* const router = host_.router()) router->on_written(its, sample);
  if (its.gated) its.origin = {message, its.written, core.now};
  const Status status = its.gated ? its.gated->write(message) : Status::ok;
  if (core.observer != nullptr) report(its, message.get(), status);
  return status;
}

std::optional<WriterInfo> SimProcess::writer(const Topic& its, std::uint64_t source) const {
  for (const Topic* one : its.on_host->processes) {
    if (one->source == source) return WriterInfo{host_.name(), one->end.user_data};
  }
  const auto carried = its.on_host->carried.find(source);
  if (carried != its.on_host->carried.end()) return carried->second;
  return network_.endpoints.writer(its.endpoint.topic.name, source);
}

void SimProcess::report(const Topic& its, const void* message, Status status) const {
  const Core& core = network_.core;
  const bool crosses = its.gated != nullptr || its.end.traffic_class.has_value();
  const std::size_t bytes = crosses ? its.endpoint.type->serialized_size(message) : 0;
  core.observer->on_written({its.end, core.now, its.written, bytes, message, status});
}

std::int64_t SimProcess::wall_ns(Time t) const {
  return Core::wall_ns(t) + host_.clock_offset().count();
}

void SimProcess::die() {
  for (const auto& [name, its] : topics_) {
    SimHost::detach(*its);
    if (SimLinkBus* const router = host_.router()) router->on_writer_gone(*its);
    if (its->reader) {
      its->reader->die();
      network_.endpoints.remove(name, *its->reader);
    }
    if (its->writer == nullptr) continue;
    its->writer->die();
    network_.endpoints.remove(name, *its->writer);
  }
}

std::unique_ptr<LinkBus> SimProcess::open_link(const std::function<void()>& on_event) {
  return std::make_unique<SimLinkBus>(network_, host_, on_event);
}

void SimProcess::set_gate(bool open) {
  gate_open_ = open;
  if (Observer* observer = network_.core.observer) {
    observer->on_gate({host_.name(), name_, now(), open});
  }
  for (const auto& entry : topics_) {
    if (entry.second->gated) entry.second->gated->set_open(open);
  }
}

std::vector<TopicTraffic> SimProcess::link_traffic() const {
  std::vector<TopicTraffic> all;
  all.reserve(topics_.size());
  for (const auto& entry : topics_) {
    if (entry.second->gated) all.push_back(entry.second->gated->traffic());
  }
  return all;
}

}  // namespace tocsin::simulation
