// SPDX-License-Identifier: Apache-2.0
#include "call_link.hpp"

#include <algorithm>
#include <iterator>

#include "call_messages.hpp"
#include "router_messages.hpp"
#include "runtime/middleware/action_ports.hpp"
#include "runtime/middleware/link_permissions.hpp"
#include "runtime/middleware/refused_names.hpp"

namespace tocsin {
namespace {

using ServicesMessage = tocsin_msgs::msg::LinkServices;

/// Of one router that may be under way at once.
constexpr int calls_depth = 256;
/// An action takes no longer.
constexpr double result_lifespan_s = 3600;

/// The reply follows when the action is over.
bool is_of_a_result(const std::string& service) {
  const std::string end = action_end("", "get_result");
  return service.size() > end.size() &&
         service.compare(service.size() - end.size(), end.size(), end) == 0;
}

Time deadline_of(const std::string& service, const CallRule& rule, Time now) {
  return now + seconds(is_of_a_result(service) ? result_lifespan_s : rule.how.deadline_s);
}

router::Crossing crossing_of(const CallRule* rule) {
  if (rule == nullptr) return router::Crossing::no;
  return rule->on_demand ? router::Crossing::on_demand : router::Crossing::always;
}

router::ServiceDirectory::Rules rules_of(const LinkBus& link) {
  return {[&link](const std::string& name) { return crossing_of(link.rules().served(name)); },
          [&link](const std::string& name) { return crossing_of(link.rules().called(name)); }};
}

Flow calls_flow(const std::string& topic, double lifespan_s) {
  Flow flow;
  flow.topic = topic;
  flow.type = type_info<tocsin_msgs::msg::LinkCall>().name;
  flow.reliable = true;
  flow.depth = calls_depth;
  flow.lifespan_s = lifespan_s;
  return flow;
}

Flow services_flow() {
  Flow flow;
  flow.topic = link_services_topic;
  flow.type = type_info<ServicesMessage>().name;
  flow.reliable = true;
  flow.transient_local = true;
  return flow;
}

/// Each is twelve endpoints of DDS, which a tick makes in some milliseconds.
constexpr int most_begun = 4;
constexpr Duration between_begun = std::chrono::milliseconds(10);

/// Ends what is not in `wanted`, and begins some of what is not in `now`. Returns whether more is
/// to begin. What is there keeps its room: a peer that names too much displaces nothing.
template <class End, class Begin>
bool follow_set(std::set<router::ServiceName>& now, const std::set<router::ServiceName>& wanted,
                End end, Begin begin) {
  for (auto it = now.begin(); it != now.end();) {
    if (wanted.count(*it) == 0) end(it->name);
    it = wanted.count(*it) == 0 ? now.erase(it) : std::next(it);
  }
  int begun = 0;
  for (const router::ServiceName& one : wanted) {
    if (now.count(one) != 0) continue;
    if (now.size() >= router::ServiceDirectory::most_services) return false;
    if (begun++ == most_begun) return true;
    begin(HostService{one.name, one.type});
    now.insert(one);
  }
  return false;
}

}  // namespace

CallLink::CallLink(const LinkParts& parts)
    : parts_(parts), host_(parts.link.services()), directory_(rules_of(parts.link)) {
  if (host_ == nullptr) return;
  services_ = open(services_flow(), TrafficClass::high);
  for (const CallClass& one : parts_.link.rules().call_classes()) open_calls(one);
}

FlowId CallLink::open(const Flow& flow, TrafficClass traffic_class) {
  TrafficRule rule;
  rule.traffic_class = traffic_class;
  const FlowId id = parts_.link.open(flow, traffic_class);
  router::StreamRule stream = stream_rule(flow, rule);
  stream.paths = parts_.link.rules().paths_of(traffic_class);
  stream.repaired = true;  // whatever its class: nobody asks twice
  parts_.streams.add(id, stream);
  return id;
}

void CallLink::open_calls(const CallClass& calls) {
  CallFlows& flows = by_class_[{calls.server, calls.traffic_class}];
  flows.calls = open(calls_flow(link_calls_topic(calls), calls.deadline_s), calls.traffic_class);
  flows.results =
      open(calls_flow(link_results_topic(calls), result_lifespan_s), calls.traffic_class);
}

bool CallLink::takes(const std::string& topic) const {
  if (topic == link_services_topic) return true;
  for (const Role role : roles) {
    for (const TrafficClass one : traffic_classes) {
      const CallClass calls{role, one};
      if (topic == link_calls_topic(calls) || topic == link_results_topic(calls)) return true;
    }
  }
  return false;
}

void CallLink::on_remote(const RemoteFlow& flow, const link_event::LinkSample& event, Instant at) {
  if (parts_.on_arrived(flow, event, at.now) != router::Disposition::deliver) return;
  const LinkPeer& peer = *parts_.peers.find(flow.peer);
  if (flow.what.topic == link_services_topic) return on_services(peer, event.sample);
  on_call(peer, event.sample, at.now);
}

void CallLink::follow(Instant at) {
  if (host_ == nullptr) return;
  while (const auto event = host_->take()) {
    std::visit([this, at](const auto& what) { on(what, at); }, *event);
  }
  follow_directory(at);
  ask_waiting(at.now);
  give_up(at.now);
}

void CallLink::on(const host_service_event::Server& event, Instant) {
  directory_.on_server({event.what.name, event.what.type}, event.there);
}

void CallLink::on(const host_service_event::Client& event, Instant at) {
  directory_.on_client({event.what.name, event.what.type}, event.there, at.now);
}

void CallLink::on(const host_service_event::Request& event, Instant at) {
  const CallRule* const rule = parts_.link.rules().called(event.service);
  if (rule == nullptr) return;
  own_.add(++last_call_, {event.service, event.id, deadline_of(event.service, *rule, at.now)});
  CallMessage message;
  message.caller(parts_.link.self());
  message.number(last_call_);
  message.reply(false);
  message.service(event.service);
  message.data(event.message);
  offer(*rule, std::move(message), at);
}

void CallLink::on(const host_service_event::Reply& event, Instant at) {
  const auto asked = served_.take({event.service, event.number});
  const CallRule* const rule = parts_.link.rules().served(event.service);
  if (!asked || rule == nullptr) return;
  CallMessage message;
  message.caller(asked->what.instance);
  message.number(asked->what.number);
  message.reply(true);
  message.service(event.service);
  message.data(event.message);
  offer(*rule, std::move(message), at);
}

void CallLink::on_services(const LinkPeer& peer, const CarriedSample& sample) {
  const auto content = parts_.link.unpack(type_info<ServicesMessage>(), sample);
  const auto* message = static_cast<const ServicesMessage*>(content.get());
  if (message == nullptr) return;
  for (const std::string& refused : directory_.on_peer(peer.instance, to_lists(*message))) {
    refuse("service", refused, peer.name, parts_.log);
  }
}

void CallLink::on_call(const LinkPeer& peer, const CarriedSample& sample, Time now) {
  const auto content = parts_.link.unpack(type_info<CallMessage>(), sample);
  const auto* message = static_cast<const CallMessage*>(content.get());
  if (host_ == nullptr || message == nullptr) return;
  if (!message->reply()) {
    const CallRule* const rule = parts_.link.rules().served(message->service());
    if (rule == nullptr) return refuse("call of", message->service(), peer.name, parts_.log);
    take_request(*message, *rule, now);
  } else if (message->caller() == parts_.link.self()) {
    const auto call = own_.take(message->number());
    if (call) host_->reply(call->service, call->what, message->data());
  }
}

void CallLink::take_request(const CallMessage& message, const CallRule& rule, Time now) {
  waiting_.add(++last_request_, {message.service(),
                                 {{message.caller(), message.number()}, message.data()},
                                 deadline_of(message.service(), rule, now)});
}

/// As far as their servers are there.
void CallLink::ask_waiting(Time now) {
  for (const std::uint64_t key : std::vector<std::uint64_t>(waiting_.keys())) {
    const auto& call = waiting_.of(key);
    if (call.deadline <= now) continue;
    const auto number = host_->ask(call.service, call.what.message);
    if (!number) continue;
    served_.add({call.service, *number}, {call.service, call.what.caller, call.deadline});
    waiting_.take(key);
  }
}

void CallLink::give_up(Time now) {
  for (const auto& call : own_.take_expired(now)) {
    const bool silent = parts_.sender.state(now).live_peers == 0;
    parts_.log.error("a call of /{} has no reply, and is given up{}", call.service,
                     silent ? ": nobody answers on the link" : "");
  }
  for (const auto& call : waiting_.take_expired(now)) {
    parts_.log.warn("a peer calls /{}, and no server has come for it", call.service);
  }
  (void)served_.take_expired(now);
}

void CallLink::follow_directory(Instant at) {
  const bool has_changed = directory_.has_changed(at.now);
  if (!has_changed && !makes_endpoints_ && is_announced_) return;
  const bool shows = follow_set(
      shown_, directory_.shown(at.now), [this](const auto& name) { host_->end_serving(name); },
      [this](const HostService& service) { host_->serve(service); });
  const bool asks = follow_set(
      asked_, directory_.asked(), [this](const auto& name) { host_->end_calling(name); },
      [this](const HostService& service) { host_->call(service); });
  makes_endpoints_ = shows || asks;
  auto offered = directory_.offered_there();
  if (offered != known_) host_->know(offered);
  known_ = std::move(offered);
  const router::ServiceLists lists = directory_.announced(at.now);
  is_announced_ = lists == announced_ || parts_.link.self() != 0;
  if (lists == announced_ || !is_announced_) return;
  announced_ = lists;
  offer(services_,
        parts_.link.pack(type_info<ServicesMessage>(),
                         std::make_shared<ServicesMessage>(to_message(lists))),
        at);
}

void CallLink::offer(const CallRule& rule, CallMessage message, Instant at) {
  const CallFlows& flows = by_class_.at({rule.how.server, rule.how.traffic_class});
  const FlowId flow = is_of_a_result(message.service()) ? flows.results : flows.calls;
  offer(
      flow,
      parts_.link.pack(type_info<CallMessage>(), std::make_shared<CallMessage>(std::move(message))),
      at);
}

void CallLink::offer(FlowId flow, CarriedSample sample, Instant at) {
  const router::Origin origin{parts_.link.self(), ++sequences_[flow], Time(Duration(at.wall_ns))};
  parts_.sender.offer(flow, {origin, sample.bytes, std::move(sample.content)}, at.now);
}

Time CallLink::deadline(Time now) const {
  return std::min({directory_.deadline(now), own_.deadline(), waiting_.deadline(),
                   served_.deadline(), makes_endpoints_ ? now + between_begun : never});
}

}  // namespace tocsin
