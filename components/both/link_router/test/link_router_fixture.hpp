// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <string>

#include "link_router/link_router_component.hpp"
#include "scripted_link.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

using Acknowledgement = tocsin_msgs::msg::LinkAcknowledgement;
inline constexpr FlowId host_flow = 500;
inline constexpr FlowId peer_flow = 600;
inline constexpr FlowId acknowledgement_flow = 601;
inline constexpr PeerId station = 77;

/// A router, of the vehicle unless a test says else, on a scripted link, in virtual time.
class LinkRouterTest : public ::testing::Test {
 protected:
  LinkRouterTest() { start_as(Role::uxv); }
  /// A router of that side begins on a link where nothing has happened.
  void start_as(Role role) {
    host_.reset();
    script_ = {};
    role_ = role;
    script_.rules = TrafficRules(std::string(TOCSIN_REPOSITORY) + "/config/traffic.yaml", role);
    start({}, this_computer());
  }
  /// An instance of the router; the one before has ended.
  void start(const LinkRouterComponent::Params& params, const Computer& computer) {
    host_.reset();
    host_.emplace(script_, role_, params, computer);
    run(0);
  }

  static Flow flow(const std::string& topic) {
    Flow flow;
    flow.topic = topic;
    flow.type = "some_msgs::msg::dds_::Type_";
    return flow;
  }
  /// A component of this host begins to write `topic`. Returns the link's flow for it.
  FlowId begin(const std::string& topic, FlowId id = host_flow) {
    script_.happen(link_event::HostFlow{id, flow(topic)});
    run(0);
    return script_.opened_for(topic);
  }
  void meet(PeerId instance = station) {
    script_.happen(link_event::PeerFound{instance, "gcs"});
    run(0);
  }
  void listen(FlowId on_link) {
    script_.happen(link_event::PeerReaderMatched{on_link, station});
    run(0);
  }
  void write(std::uint64_t sequence, FlowId id = host_flow, std::uint32_t bytes = 100) {
    CarriedSample sample;
    sample.content = std::make_shared<int>(static_cast<int>(sequence));
    sample.bytes = bytes;
    sample.source = 9;
    sample.sequence = sequence;
    sample.sent_wall_ns = host_->bus.wall_ns(host_->bus.now());
    script_.happen(link_event::HostSample{id, sample, host_->bus.now()});
    run(0);
  }
  /// A peer's flow and one transmission on it.
  void receive(std::uint64_t number, std::uint64_t sequence, SamplePiece piece = {},
               SampleCoding coding = {}) {
    receive_by(peer_flow, number, sequence, piece, coding);
  }
  void receive_by(FlowId flow, std::uint64_t number, std::uint64_t sequence, SamplePiece piece = {},
                  SampleCoding coding = {}) {
    CarriedSample sample;
    sample.bytes = 100;
    sample.source = 3;
    sample.sequence = sequence;
    sample.coding = coding;
    sample.sent_wall_ns = host_->bus.wall_ns(host_->bus.now());
    script_.happen(link_event::LinkSample{flow, number, sample, host_->bus.now(), piece});
    run(0);
  }
  void begin_peer_flow(const std::string& topic, FlowId id = peer_flow, PathIndex path = 0) {
    Flow what = flow(topic);
    what.path = path;
    script_.happen(link_event::PeerFlow{id, station, id + 1, what});
    run(0);
  }
  void acknowledge(FlowId on_link, std::uint64_t highest, std::uint32_t count = 1) {
    auto acknowledgement = std::make_shared<Acknowledgement>();
    acknowledgement->from_instance(station);
    acknowledgement->to_instance(ScriptedLink::own_instance);
    acknowledgement->count(count);
    acknowledgement->made_ns(host_->bus.now().time_since_epoch().count());
    acknowledgement->streams({1000 + on_link});
    acknowledgement->highest({static_cast<std::uint32_t>(highest)});
    acknowledgement->age_100us({10});
    acknowledgement->before({0});
    tell(acknowledgement);
  }
  void tell(const std::shared_ptr<Acknowledgement>& acknowledgement) {
    CarriedSample sample;
    sample.content = acknowledgement;
    script_.happen(link_event::LinkSample{acknowledgement_flow, 1, sample, host_->bus.now()});
    run(0);
  }
  void set_active(bool active, const std::string& role = "uxv") {
    tocsin_msgs::msg::TransmissionState state;
    state.role(role);
    state.active(active);
    host_->bus.publish<topic::TransmissionState>(state);
    run(0);
  }
  void run(double s) { host_->bus.run_for(seconds(s)); }

  struct Host {
    Host(ScriptedLink& script, Role role, const LinkRouterComponent::Params& params,
         const Computer& computer)
        : bus(script),
          context(Context(bus, "link_router", role).with_computer(computer)),
          router(context, params) {
      bus.add(router);
    }
    RoutedSimBus bus;
    Context context;
    SimReader<topic::LinkState> states{bus};
    SimReader<topic::LinkBudget> budgets{bus};
    SimReader<topic::TrafficReport> reports{bus};
    LinkRouterComponent router;
  };
  Role role_ = Role::uxv;
  ScriptedLink script_;
  std::optional<Host> host_;
};

}  // namespace tocsin
