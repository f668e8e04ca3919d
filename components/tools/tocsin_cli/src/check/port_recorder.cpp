// SPDX-License-Identifier: Apache-2.0
#include "port_recorder.hpp"

#include <algorithm>
#include <utility>

namespace tocsin::check {
namespace {

struct Silent : Subscription {};

/// Nobody hears it.
class NullPublication final : public Publication {
 public:
  Status write(const std::shared_ptr<const void>& message) override {
    (void)message;
    return Status::ok;
  }
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
                      topic.requests, endpoint.writers});
    return;
  }
  if (endpoint.writers == Writers::needed) known->writers = Writers::needed;
  if (topic.requests == Requests::profile) known->requests = Requests::profile;
}

std::unique_ptr<Subscription> PortRecorder::subscribe(const Endpoint& endpoint,
                                                      Receiver& receiver) {
  (void)receiver;
  record(endpoint, false);
  return std::make_unique<Silent>();
}

std::unique_ptr<Publication> PortRecorder::advertise(const Endpoint& endpoint) {
  record(endpoint, true);
  return std::make_unique<NullPublication>();
}

}  // namespace tocsin::check
