// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "foundation/temporary_folder.hpp"
#include "link_router_fixture.hpp"
#include "runtime/middleware/link_permissions.hpp"
#include "tocsin_idl/link_calls.hpp"

namespace tocsin {

using CallMessage = tocsin_msgs::msg::LinkCall;
using ServicesMessage = tocsin_msgs::msg::LinkServices;
using Bytes = std::vector<std::uint8_t>;

inline constexpr FlowId peer_services = 700;
inline constexpr FlowId peer_calls = 800;
inline const HostService dock{"dock", "std_srvs/srv/Trigger"};
inline const Bytes question{0, 1, 0, 0, 1, 2};
inline const Bytes answer{0, 1, 0, 0, 7};
inline const std::string rules =
    "uxv:\n  high: {services: [dock, '*/get_parameters'], actions: [drive], call_deadline_s: 2}\n"
    "gcs:\n  high: {topics: [goal]}\n";

/// A router on a scripted link and a scripted host, in virtual time.
class CallLinkTest : public LinkRouterTest {
 protected:
  /// A router of the vehicle, which serves, or of the station, which calls.
  void begin_as(Role role) {
    host_.reset();
    script_.opened.clear();
    script_.rules = TrafficRules(folder_.write("traffic.yaml", rules), role);
    start({}, this_computer());
    meet();
    begin_peer_flow(link_services_topic, peer_services);
    begin_peer_flow("link_calls_uxv_high", peer_calls);
  }
  void happen(HostServiceEvent event) {
    script_.services.events.push_back(std::move(event));
    script_.on_event();
    run(0);
  }
  template <class Message>
  void receive(FlowId flow, const Message& message) {
    CarriedSample sample;
    sample.content = std::make_shared<Message>(message);
    sample.bytes = 100;
    sample.source = flow;
    sample.sequence = ++received_;
    sample.sent_wall_ns = host_->bus.wall_ns(host_->bus.now());
    script_.happen(link_event::LinkSample{flow, received_, sample, host_->bus.now()});
    run(0);
  }
  /// The peer's host has or wants these.
  void hear_of(const std::vector<HostService>& offered, const std::vector<HostService>& wanted) {
    ServicesMessage message;
    const auto add = [](auto& list, const HostService& one) {
      list.emplace_back();
      list.back().name(one.name);
      list.back().type(one.type);
    };
    for (const HostService& one : offered) add(message.offered(), one);
    for (const HostService& one : wanted) add(message.wanted(), one);
    receive(peer_services, message);
  }
  static CallMessage call(std::uint64_t caller, std::uint64_t number, bool reply,
                          const Bytes& data) {
    CallMessage message;
    message.caller(caller);
    message.number(number);
    message.reply(reply);
    message.service(dock.name);
    message.data(data);
    return message;
  }
  template <class Message>
  [[nodiscard]] std::vector<Message> sent(const std::string& topic) const {
    std::vector<Message> messages;
    for (const ScriptedLink::Sent& one : script_.sent) {
      if (script_.opened.at(one.flow).flow.topic != topic) continue;
      messages.push_back(*static_cast<const Message*>(one.sample.content.get()));
    }
    return messages;
  }
  [[nodiscard]] std::vector<CallMessage> sent_calls() const {
    return sent<CallMessage>("link_calls_uxv_high");
  }
  static CallId id(std::uint8_t client) {
    CallId id;
    id.client[0] = client;
    id.number = 5;
    return id;
  }

  const TemporaryFolder folder_;

 private:
  std::uint64_t received_ = 0;
};

}  // namespace tocsin
