// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sim_host.hpp"
#include "sim_link_bus.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::simulation {

template <class Topic>
Endpoint endpoint(const char* user_data = "") {
  return {Topic::info, &type_info<typename Topic::Message>(), Writers::needed, user_data};
}

template <class Topic>
std::shared_ptr<const typename Topic::Message> message() {
  return std::make_shared<const typename Topic::Message>();
}

inline std::shared_ptr<const topic::CameraImage::Message> picture(std::size_t bytes) {
  auto made = std::make_shared<topic::CameraImage::Message>();
  made->data().resize(bytes);
  return made;
}

/// Keeps what it reads.
class Reader : public Receiver {
 public:
  void receive(const Sample& sample) override { samples.push_back(sample); }
  std::vector<Sample> samples;
};

/// Decides nothing: all that it is told of crosses, with the DSCP of its class. States are sent
/// again to whoever comes to read them.
class PlainRouter {
 public:
  PlainRouter(Network& network, SimHost& host)
      : rules_(host.rules()),
        process(host.add_process("router")),
        bus(network, process, host, [this] { ++wake_ups; }) {}
  void work() {
    while (auto event = bus.take()) {
      std::visit([this](const auto& what) { on(what); }, *event);
      events.push_back(std::move(*event));
    }
  }
  /// Those of one kind, in order.
  template <class Event>
  [[nodiscard]] std::vector<Event> got() const {
    std::vector<Event> all;
    for (const LinkEvent& event : events) {
      if (const auto* one = std::get_if<Event>(&event)) all.push_back(*one);
    }
    return all;
  }
  template <class Event>
  [[nodiscard]] std::size_t count() const {
    return got<Event>().size();
  }

 private:
  const TrafficRules& rules_;

 public:
  SimProcess& process;
  int wake_ups = 0;  // before the bus, whose constructor already tells of something
  SimLinkBus bus;
  std::vector<LinkEvent> events;
  std::map<FlowId, FlowId> opened;  ///< flow on the link, by that of the host
  std::vector<std::uint64_t> numbers;

 private:
  template <class Event>
  void on(const Event&) {}
  void on(const link_event::HostFlow& flow) {
    opened[flow.flow] = bus.open(flow.what, rules_.of(flow.what.topic).traffic_class);
    if (flow.what.transient_local) states_[opened[flow.flow]] = {};
  }
  void on(const link_event::HostFlowGone& flow) { bus.close(opened[flow.flow]); }
  void on(const link_event::HostSample& one) {
    const FlowId flow = opened[one.flow];
    if (states_.count(flow) != 0) states_[flow] = one.sample;
    numbers.push_back(bus.send(flow, one.sample, {}, 0).value_or(0));
  }
  void on(const link_event::PeerReaderMatched& one) {
    const auto state = states_.find(one.flow);
    if (state != states_.end() && state->second.content)
      (void)bus.send(one.flow, state->second, {}, 0);
  }
  void on(const link_event::PeerReaderGone&) {}
  void on(const link_event::PeerFlow& flow) { bus.offer(flow.flow); }
  void on(const link_event::LinkSample& one) { bus.deliver(one.flow, one.sample); }
  std::map<FlowId, CarriedSample> states_;
};

/// A vehicle with two processes, a ground station with two, a tablet with none, and a radio that is
/// dead from 100 s to 105 s and takes 10 ms otherwise.
class LinkBusTest : public ::testing::Test {
 protected:
  template <class Topic>
  Reader& read(SimProcess& process) {
    readers_.push_back(std::make_unique<Reader>());
    subscriptions_.push_back(process.subscribe(endpoint<Topic>(), *readers_.back()));
    return *readers_.back();
  }
  template <class Topic>
  static void write(SimProcess& process, int count = 1) {
    const auto writer = process.advertise(endpoint<Topic>());
    for (int i = 0; i < count; ++i) EXPECT_EQ(writer->write(message<Topic>()), Status::ok);
  }
  PlainRouter& start(SimHost& host) {
    auto& router = routers_[host.name()];
    router = std::make_unique<PlainRouter>(network_, host);
    return *router;
  }
  void kill_router(const SimHost& host) { routers_.erase(host.name()); }
  /// Both routers know each other.
  void connect() {
    start(uxv_);
    start(gcs_);
    run_for(0.2);
  }
  PlainRouter& up() { return *routers_.at("uxv"); }
  PlainRouter& down() { return *routers_.at("gcs"); }
  void run_for(double s) { run_until(core_.now + seconds(s)); }
  void run_until(Time end) {
    const auto next = [this] { return std::min(core_.events.next(), link_.next_event()); };
    work();
    for (Time at = next(); at <= end; at = next()) {
      core_.now = std::max(core_.now, at);
      core_.events.run(core_.now);
      link_.advance();
      work();
    }
    core_.now = end;
  }
  static radio::ChannelParams wire() {
    radio::ChannelParams params;
    params.mode = "bernoulli";
    params.delay_s = 0.01;
    params.outages_s = {100, 5};
    return params;
  }

  Core core_;
  RadioLink link_{core_, wire(), {{}, 1, 1}};
  Network network_{core_, link_, QosProfiles(TOCSIN_REPOSITORY "/config/qos.yaml")};
  SimHost uxv_{network_, "uxv", Role::uxv, TOCSIN_REPOSITORY "/config/traffic.yaml"};
  SimHost gcs_{network_, "gcs", Role::gcs, TOCSIN_REPOSITORY "/config/traffic.yaml"};
  SimHost tablet_{network_, "tablet", Role::gcs, TOCSIN_REPOSITORY "/config/traffic.yaml"};
  SimProcess& drive_ = uxv_.add_process("drive");
  SimProcess& payload_ = uxv_.add_process("payload");
  SimProcess& mission_ = gcs_.add_process("mission");
  SimProcess& view_ = gcs_.add_process("view");
  std::map<std::string, std::unique_ptr<PlainRouter>> routers_;

 private:
  void work() {
    for (const auto& entry : routers_) entry.second->work();
  }
  std::vector<std::unique_ptr<Reader>> readers_;
  std::vector<std::unique_ptr<Subscription>> subscriptions_;
};

}  // namespace tocsin::simulation
