// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include "foundation/error.hpp"
#include "sim_host.hpp"

namespace tocsin::simulation {
namespace {

/// Removes the receiver when it is destroyed.
class Attached final : public Subscription {
 public:
  Attached(TopicExchange& exchange, Receiver& receiver) : exchange_(exchange), receiver_(receiver) {
    exchange_.attach(receiver_);
  }
  ~Attached() override { exchange_.detach(receiver_); }

 private:
  TopicExchange& exchange_;
  Receiver& receiver_;
};

class Written final : public Publication {
 public:
  Written(SimProcess& process, SimProcess::Topic& topic) : process_(process), topic_(topic) {}
  Status write(const std::shared_ptr<const void>& message) override {
    return process_.write(topic_, message);
  }

 private:
  SimProcess& process_;
  SimProcess::Topic& topic_;
};

}  // namespace

SimProcess::Topic::Topic(const Endpoint& its, const QosProfile& profile)
    : endpoint(its), qos(profile), exchange(profile.keeps_last()) {}

SimProcess::SimProcess(Network& network, SimHost& host, std::string name)
    : network_(network), host_(host), name_(std::move(name)) {}

SimProcess::~SimProcess() = default;

SimProcess::Topic& SimProcess::topic(const Endpoint& endpoint) {
  auto& found = topics_[endpoint.topic.name];
  if (!found) {
    const std::string name = endpoint.topic.name;
    found = std::make_unique<Topic>(endpoint, network_.qos.of(endpoint.topic.qos, name));
    found->label = host_.name() + "/" + name_ + "/" + name;
    found->source = hash_of(found->label);
    host_.attach(*found);
  }
  if (found->endpoint.type != endpoint.type) {
    throw ConfigError(std::string("topic ") + endpoint.topic.name + ": type " +
                      endpoint.type->name + " clashes with " + found->endpoint.type->name);
  }
  return *found;
}

std::unique_ptr<Subscription> SimProcess::subscribe(const Endpoint& endpoint, Receiver& receiver) {
  Topic& its = topic(endpoint);
  auto attached = std::make_unique<Attached>(its.exchange, receiver);
  if (endpoint.topic.scope == Scope::link && !its.reader) make_reader(its);
  return attached;
}

std::unique_ptr<Publication> SimProcess::advertise(const Endpoint& endpoint) {
  Topic& its = topic(endpoint);
  if (endpoint.topic.scope == Scope::link && !its.gated) make_writer(its);
  return std::make_unique<Written>(*this, its);
}

void SimProcess::make_reader(Topic& its) {
  const auto deliver = [this, &its](const Change& change, std::uint64_t source) {
    const std::shared_ptr<void> message = its.endpoint.type->create();
    if (!its.endpoint.type->deserialize(change.cdr->data(), change.cdr->size(), message.get())) {
      return;
    }
    Sample sample;
    sample.message = message;
    sample.received = now();
    sample.sent_wall_ns = wall_ns(change.written);
    sample.received_wall_ns = wall_ns(now());
    sample.sequence = change.sequence;
    sample.source = source;
    sample.bytes = static_cast<std::uint32_t>(change.cdr->size());
    its.exchange.deliver(sample);
  };
  its.reader = std::make_unique<RtpsReader>(its.qos, deliver);
  network_.endpoints.add(its.endpoint.topic.name, host_, *its.reader);
}

void SimProcess::make_writer(Topic& its) {
  const TrafficRule& rule = host_.rules().of(its.endpoint.topic.name);
  auto writer = std::make_unique<RtpsWriter>(network_.core, network_.link, host_.direction(),
                                             its.source, *its.endpoint.type, its.qos);
  its.writer = writer.get();
  its.gated = std::make_unique<GatedWriter>(its.endpoint.topic.name, *its.endpoint.type, rule,
                                            std::move(writer));
  its.gated->set_open(gate_open_);
  network_.endpoints.add(its.endpoint.topic.name, host_, *its.writer);
}

Status SimProcess::write(Topic& its, const std::shared_ptr<const void>& message) {
  network_.core.digest.add_sample(now(), its.label, *its.endpoint.type, message.get());
  Sample sample;
  sample.message = message;
  sample.received = now();
  sample.sent_wall_ns = sample.received_wall_ns = wall_ns(now());
  sample.sequence = ++its.written;
  sample.source = its.source;
  host_.deliver(its, sample);
  return its.gated ? its.gated->write(message) : Status::ok;
}

void SimProcess::set_gate(bool open) {
  gate_open_ = open;
  for (const auto& entry : topics_) {
    if (entry.second->gated) entry.second->gated->set_open(open);
  }
}

std::vector<TopicTraffic> SimProcess::link_traffic() const {
  std::vector<TopicTraffic> all;
  for (const auto& entry : topics_) {
    if (entry.second->gated) all.push_back(entry.second->gated->traffic());
  }
  return all;
}

}  // namespace tocsin::simulation
