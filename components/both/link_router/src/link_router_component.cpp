// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_router_component.hpp"

#include <algorithm>
#include <utility>

#include "foundation/error.hpp"
#include "router_messages.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/middleware/link_permissions.hpp"

namespace tocsin {
namespace {

/// What routers tell each other; on the link only.
using Receipt = tocsin_msgs::msg::LinkReceipt;

/// Lives are compared here, where the wire tells them; the decisions see one life of each side.
constexpr router::Incarnation this_life = 1;

Flow receipt_flow() {
  Flow flow;
  flow.topic = link_receipt_topic;
  flow.type = type_info<Receipt>().name;
  return flow;
}

router::Origin origin_of(const CarriedSample& sample) {
  return {sample.source, sample.sequence, Time(Duration(sample.sent_wall_ns))};
}

CarriedSample carried(const router::Sample& sample) {
  return {sample.content, static_cast<std::uint32_t>(sample.bytes), sample.origin.source,
          sample.origin.sequence, sample.origin.sent.time_since_epoch().count()};
}

std::unique_ptr<LinkBus> open_link(Bus& bus, Schedule& schedule) {
  auto link = bus.open_link([&schedule] { schedule.input_arrived(); });
  if (!link) throw ConfigError("link_router: this process has no address on the link");
  return link;
}

}  // namespace

LinkRouterComponent::LinkRouterComponent(Context& context, const Params& params)
    : Component(context),
      params_(params),
      keeper_(seconds(params.silence_limit_s)),
      sender_(params.link, this_life),
      receiver_(params.link, this_life),
      link_(open_link(bus(), schedule())),
      receipts_(link_->open(receipt_flow(), TrafficClass::critical)) {}

void LinkRouterComponent::tick(Time now) {
  follow_gate(now);
  take_events(now);
  send(now);
  answer(now);
  if (now >= next_budget_) tell_budgets(now);
  if (now >= next_report_) report(now);
  wake_at(std::min({sender_.deadline(now), receiver_.deadline(), keeper_.deadline(now),
                    next_budget_, next_report_}));
}

void LinkRouterComponent::follow_gate(Time now) {
  while (const auto state = state_.take()) {
    if (role_of(state->role()) == context().role) keeper_.on_state(state->active(), now);
  }
  const bool open = keeper_.open(now);
  if (open == std::exchange(open_, open)) return;
  sender_.set_paused(!open, now);
  link_->on_gate(open);
}

void LinkRouterComponent::take_events(Time now) {
  while (const auto event = link_->take()) {
    std::visit([this, now](const auto& what) { on(what, now); }, *event);
  }
}

void LinkRouterComponent::on(const link_event::HostFlow& event, Time) {
  const TrafficRule& rule = link_->rules().of(event.what.topic);
  Outgoing& flow = outgoing_[event.flow];
  flow.on_link = link_->open(event.what, rule.traffic_class);
  flow.topic = event.what.topic;
  flow.rule = stream_rule(event.what, rule);
  by_link_[flow.on_link] = &flow;
  sender_.add_stream(flow.on_link, flow.rule);
}

void LinkRouterComponent::on(const link_event::HostFlowGone& event, Time now) {
  const auto found = outgoing_.find(event.flow);
  if (found == outgoing_.end()) return;
  send(now);  // the last words of who left
  sender_.remove_stream(found->second.on_link);
  link_->close(found->second.on_link);
  by_link_.erase(found->second.on_link);
  outgoing_.erase(found);
}

void LinkRouterComponent::on(const link_event::HostSample& event, Time now) {
  const auto found = outgoing_.find(event.flow);
  if (found == outgoing_.end()) return;
  sender_.offer(found->second.on_link,
                {origin_of(event.sample), event.sample.bytes, event.sample.content}, now);
}

void LinkRouterComponent::on(const link_event::PeerFound& event, Time now) {
  peers_[event.peer] = event.name;
  lives_[event.name] = event.peer;
  sender_.on_peer(event.name, event.peer, now);
  receiver_.on_peer(event.name, event.peer);
  log().info("{} is on the link", event.name);
}

void LinkRouterComponent::on(const link_event::PeerLost& event, Time now) {
  const auto found = peers_.find(event.peer);
  if (found == peers_.end()) return;
  if (lives_[found->second] == event.peer) {
    sender_.forget_peer(found->second, now);
    receiver_.forget_peer(found->second);
    lives_.erase(found->second);
    log().warn("{} has left the link", found->second);
  }
  peers_.erase(found);
}

void LinkRouterComponent::on(const link_event::PeerFlow& event, Time) {
  const auto peer = peers_.find(event.peer);
  if (peer == peers_.end()) return;
  const bool is_receipt = event.what.topic == link_receipt_topic;
  incoming_[event.flow] = {event.peer, event.wire_id, is_receipt};
  if (is_receipt) return;
  receiver_.on_stream(peer->second, event.wire_id, stream_rule(event.what, {}));
  link_->offer(event.flow);
}

void LinkRouterComponent::on(const link_event::PeerFlowGone& event, Time) {
  const auto found = incoming_.find(event.flow);
  if (found == incoming_.end()) return;
  const auto peer = peers_.find(found->second.peer);
  if (peer != peers_.end()) receiver_.forget_stream(peer->second, found->second.wire_id);
  incoming_.erase(found);
}

void LinkRouterComponent::on(const link_event::PeerListens& event, Time now) {
  const auto peer = peers_.find(event.peer);
  const bool is_stream = by_link_.count(event.flow) != 0;
  if (peer != peers_.end() && is_stream) sender_.set_wanted(peer->second, event.flow, true, now);
}

void LinkRouterComponent::on(const link_event::LinkSample& event, Time now) {
  const auto from = incoming_.find(event.flow);
  if (from == incoming_.end()) return;
  const auto peer = peers_.find(from->second.peer);
  if (peer == peers_.end()) return;
  if (from->second.is_receipt) return take_receipt(from->second, event.sample, now);
  const router::Disposition disposition = receiver_.on_arrived(
      peer->second, {from->second.wire_id, event.number, origin_of(event.sample)}, now);
  if (disposition == router::Disposition::deliver) link_->give(event.flow, event.sample);
}

void LinkRouterComponent::take_receipt(const Incoming& from, const CarriedSample& sample,
                                       Time now) {
  const auto content = link_->unpack(type_info<Receipt>(), sample);
  const auto* message = static_cast<const Receipt*>(content.get());
  if (message == nullptr || message->to_life() != link_->self()) return;
  auto receipt = to_receipt(*message, [this](std::uint32_t id) { return stream_of(id); });
  if (!receipt) return;
  receipt->from = from.peer;
  receipt->to = this_life;
  sender_.on_receipt(peers_.at(from.peer), *receipt, now);
}

std::optional<router::StreamId> LinkRouterComponent::stream_of(std::uint32_t wire_id) const {
  const auto found = std::find_if(by_link_.begin(), by_link_.end(), [&](const auto& entry) {
    return link_->wire_id(entry.first) == wire_id;
  });
  return found == by_link_.end() ? std::nullopt : std::optional(found->first);
}

void LinkRouterComponent::send(Time now) {
  while (const auto transmission = sender_.next(now)) {
    Outgoing& flow = *by_link_.at(transmission->stream);
    const auto number = link_->send(transmission->stream, carried(transmission->sample));
    if (number != transmission->number) {
      sender_.on_not_written(*transmission, now);
      continue;
    }
    flow.sent_bytes += transmission->sample.bytes;
  }
}

void LinkRouterComponent::answer(Time now) {
  while (const auto due = receiver_.take_receipt(now)) {
    auto message = std::make_shared<Receipt>(to_message(due->receipt));
    message->from_life(link_->self());
    message->to_life(lives_[due->peer]);
    (void)link_->send(receipts_, link_->pack(type_info<Receipt>(), std::move(message)));
  }
}

void LinkRouterComponent::tell_budgets(Time now) {
  next_budget_ = next_instant(seconds(params_.budget_period_s), now);
  tocsin_msgs::msg::LinkBudget message;
  message.stamp(wall(now));
  message.role(to_string(context().role));
  for (const router::StreamBudget& budget : sender_.budgets(now)) {
    tocsin_msgs::msg::StreamBudget stream;
    stream.topic(by_link_.at(budget.stream)->topic);
    stream.bytes_per_s(static_cast<float>(budget.bytes_per_s));
    stream.scale(static_cast<float>(budget.scale));
    stream.hold(budget.hold);
    message.streams().push_back(std::move(stream));
  }
  if (message.streams().empty()) return;
  if (budget_.write(std::move(message)) == Status::failed) log().warn("a budget was not told");
}

void LinkRouterComponent::report(Time now) {
  next_report_ = next_instant(seconds(params_.report_period_s), now);
  tocsin_msgs::msg::LinkState message = to_message(sender_.state(now), link_->packets());
  message.stamp(wall(now));
  message.role(to_string(context().role));
  if (link_state_.write(std::move(message)) == Status::failed) {
    log().warn("the state of the link was not told");
  }
  report_traffic(now);
}

void LinkRouterComponent::report_traffic(Time now) {
  tocsin_msgs::msg::TrafficReport message;
  message.stamp(wall(now));
  message.role(to_string(context().role));
  message.process(name());
  for (const auto& entry : outgoing_) {
    const Outgoing& flow = entry.second;
    tocsin_msgs::msg::TopicTraffic one;
    one.topic(flow.topic);
    one.traffic_class(to_string(link_->rules().of(flow.topic).traffic_class));
    one.paused(!open_ && flow.rule.while_paused != router::WhilePaused::send);
    const router::StreamCounts counts = sender_.stream_counts(flow.on_link);
    one.written(counts.offered);
    one.sent(counts.sent);
    one.dropped(counts.dropped);
    one.held(counts.paused);
    one.sent_bytes(flow.sent_bytes);
    message.topics().push_back(std::move(one));
  }
  if (traffic_.write(std::move(message)) == Status::failed) {
    log().warn("the traffic report was refused by the middleware");
  }
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::LinkRouterComponent)
