// SPDX-License-Identifier: Apache-2.0
#include "port_recorder.hpp"

#include <algorithm>
#include <utility>

namespace tocsin::check {
namespace {

struct Silent : Subscription {};

/// Nobody hears it; only what it expects to write is kept.
class NullPublication final : public Publication {
 public:
  NullPublication(PortRecorder& recorder, std::string topic)
      : recorder_(recorder), topic_(std::move(topic)) {}
  Status write(const std::shared_ptr<const void>& message) override {
    (void)message;
    return Status::ok;
  }
  void expect(const std::function<ExpectedLoad()>& load) override {
    recorder_.expect(topic_, load());
  }

 private:
  PortRecorder& recorder_;
  const std::string topic_;
};

}  // namespace

void PortRecorder::record(const Endpoint& endpoint, bool writes) {
  const TopicInfo& topic = endpoint.topic;
  const auto same = [&](const Port& port) {
    return port.topic == topic.name && port.writes == writes && port.type == endpoint.type->name &&
           port.qos == topic.qos && port.scope == topic.scope;
  };
  const auto known = std::find_if(ports_.begin(), ports_.end(), same);
  if (known == ports_.end()) {
    ports_.push_back({topic.name, endpoint.type->name, topic.qos, topic.scope, writes,
                      topic.requests, endpoint.writers, std::nullopt});
    return;
  }
  if (endpoint.writers == Writers::needed) known->writers = Writers::needed;
  if (topic.requests == Requests::profile) known->requests = Requests::profile;
}

void PortRecorder::expect(const std::string& topic, const ExpectedLoad& load) {
  for (Port& port : ports_) {
    if (port.topic == topic && port.writes) port.load = load;
  }
}

std::unique_ptr<Subscription> PortRecorder::subscribe(const Endpoint& endpoint,
                                                      Receiver& receiver) {
  (void)receiver;
  record(endpoint, false);
  return std::make_unique<Silent>();
}

std::unique_ptr<Publication> PortRecorder::advertise(const Endpoint& endpoint) {
  record(endpoint, true);
  return std::make_unique<NullPublication>(*this, endpoint.topic.name);
}

}  // namespace tocsin::check
