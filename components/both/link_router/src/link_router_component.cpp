// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_router_component.hpp"

#include <algorithm>
#include <utility>

#include "arrival_log.hpp"
#include "backfill_link.hpp"
#include "backfill_messages.hpp"
#include "call_link.hpp"
#include "fetch_trigger.hpp"
#include "foundation/error.hpp"
#include "held_arrivals.hpp"
#include "router_messages.hpp"
#include "router_stop.hpp"
#include "router_store.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/middleware/link_permissions.hpp"
#include "store_places.hpp"

namespace tocsin {
namespace {

/// What routers tell each other; on the link only.
using Acknowledgement = tocsin_msgs::msg::LinkAcknowledgement;

Flow acknowledgement_flow() {
  Flow flow;
  flow.topic = link_acknowledgement_topic;
  flow.type = type_info<Acknowledgement>().name;
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
      sender_(params.link),
      receiver_(params.link),
      link_(open_link(bus(), schedule())),
      stop_(std::make_unique<RouterStop>(*this, context, *link_, log())),
      acknowledgements_(link_->open(acknowledgement_flow(), TrafficClass::critical)),
      store_(std::make_unique<RouterStore>(context.devices, store_place(context, params),
                                           [this] { schedule().input_arrived(); })),
      history_(std::make_unique<RouterStore>(context.devices, history_place(context, params),
                                             [this] { schedule().input_arrived(); })),
      arrivals_(std::make_unique<ArrivalLog>(
          ArrivalLog::Parts{*link_, *history_, [this](Time now) { return bus().wall_ns(now); }})),
      backfills_(std::make_unique<BackfillLink>(
          BackfillLink::Parts{*link_, sender_, *store_, *history_, *arrivals_, log()},
          params.link)),
      calls_(std::make_unique<CallLink>(CallLink::Parts{
          *link_, sender_, log(), [this](Time now) { return bus().wall_ns(now); }})),
      held_(std::make_unique<HeldArrivals>()) {
  for (const auto& [flow, rule] : calls_->flows()) {
    own_[flow] = {flow, rule.name, rule};
    by_link_[flow] = &own_[flow];
  }
  triggers_ = make_triggers(*this, link_->rules().fetches(),
                            backfills_->logs() ? params.fetch_around_stop_s : 0);
}

LinkRouterComponent::~LinkRouterComponent() = default;

void LinkRouterComponent::tick(Time now) {
  stop_->follow(now);
  if (now >= next_keep_) keep_store(now);
  follow_gate(now);
  take_requests(now);
  take_events(now);
  give_held(now);
  calls_->follow(now);
  backfills_->follow(now, bus().wall_ns(now));
  send(now);
  backfills_->follow(now, bus().wall_ns(now));
  answer(now);
  if (now >= next_budget_) tell_budgets(now);
  if (now >= next_report_) report(now);
  wake_at(std::min({sender_.deadline(now), receiver_.deadline(), keeper_.deadline(now),
                    backfills_->deadline(now), calls_->deadline(now), held_->deadline(),
                    stop_->deadline(), next_budget_, next_report_, next_keep_}));
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
  if (!rule.live) return backfills_->add_logged(event.flow, std::nullopt, event.what);
  Outgoing& flow = outgoing_[event.flow];
  const Flow sent = on_link(event.what, rule);
  flow.on_link = link_->open(sent, rule.traffic_class);
  flow.topic = event.what.topic;
  flow.rule = stream_rule(sent, rule);
  if (rule.max_rate_hz > 0) flow.interval = seconds(1 / rule.max_rate_hz);
  by_link_[flow.on_link] = &flow;
  sender_.add_stream(flow.on_link, flow.rule);
  if (rule.stored) backfills_->add(flow.on_link, event.what, flow.rule);
  if (rule.logged) backfills_->add_logged(event.flow, flow.on_link, event.what);
}

void LinkRouterComponent::on(const link_event::HostFlowGone& event, Time now) {
  backfills_->remove_logged(event.flow);
  const auto found = outgoing_.find(event.flow);
  if (found == outgoing_.end()) return;
  send(now);  // the last words of who left
  sender_.remove_stream(found->second.on_link);
  backfills_->remove(found->second.on_link);
  link_->close(found->second.on_link);
  by_link_.erase(found->second.on_link);
  outgoing_.erase(found);
}

bool LinkRouterComponent::passes(Outgoing& flow, std::uint64_t writer, Time now) {
  if (flow.interval == Duration::zero()) return true;
  return flow.limits.try_emplace(writer, flow.interval).first->second.pass(now);
}

void LinkRouterComponent::on(const link_event::HostSample& event, Time now) {
  backfills_->log(event.flow, event.sample, now, bus().wall_ns(now));
  const auto found = outgoing_.find(event.flow);
  if (found == outgoing_.end() || !passes(found->second, event.sample.source, now)) return;
  if (found->second.rule.stored) {
    backfills_->offer(found->second.on_link, event.sample, now, bus().wall_ns(now));
  }
  sender_.offer(found->second.on_link,
                {origin_of(event.sample), event.sample.bytes, event.sample.content}, now);
}

void LinkRouterComponent::on(const link_event::HostListens& event, Time now) {
  backfills_->on_host_listens(event.flow, now);
  held_->on_reader(event.flow, now);
}

void LinkRouterComponent::give_held(Time now) {
  for (const link_event::LinkSample& sample : held_->take(now)) on(sample, now);
}

void LinkRouterComponent::on(const link_event::LinkSample& event, Time now) {
  if (held_->hold(event)) return;
  const auto from = incoming_.find(event.flow);
  if (from == incoming_.end()) return;
  const auto peer = peers_.find(from->second.peer);
  if (peer == peers_.end()) return;
  const Incoming& flow = from->second;
  if (flow.kind == Incoming::Kind::acknowledgements)
    return take_acknowledgement(flow, event.sample, now);
  const router::Disposition disposition = receiver_.on_arrived(
      peer->second, {flow.wire_id, event.number, origin_of(event.sample)}, now);
  if (flow.kind == Incoming::Kind::backfills) {
    store_->open(now, bus().wall_ns(now));
    return backfills_->on_batch({peer->second, flow.peer}, event.sample, now);
  }
  if (disposition != router::Disposition::deliver) return;
  if (flow.kind == Incoming::Kind::services) {
    return calls_->on_services(flow.peer, peer->second, event.sample);
  }
  if (flow.kind == Incoming::Kind::calls) return calls_->on_call(peer->second, event.sample, now);
  const bool was_given =
      flow.rule.stored && !backfills_->on_live(peer->second, flow.rule, event.sample);
  if (!was_given) arrivals_->keep(flow.what, event.sample, now);
  // Late readers ask for the last sample of a state, whoever has it already.
  if (!was_given || flow.rule.durable) link_->give(event.flow, event.sample);
}

void LinkRouterComponent::take_acknowledgement(const Incoming& from, const CarriedSample& sample,
                                               Time now) {
  const auto content = link_->unpack(type_info<Acknowledgement>(), sample);
  const auto* message = static_cast<const Acknowledgement*>(content.get());
  if (message == nullptr || message->to_life() != link_->self()) return;
  auto acknowledgement =
      to_acknowledgement(*message, [this](std::uint32_t id) { return stream_of(id); });
  if (!acknowledgement) return;
  const std::string& name = peers_.at(from.peer);
  if (lives_[name] == from.peer) sender_.on_acknowledgement(name, *acknowledgement, now);
  for (const auto& request : message->requests()) {
    const auto range = to_range(request);
    if (range && backfills_->fills(from.peer)) backfills_->request(*range, now);
  }
  backfills_->on_progress(from.peer, {message->backfill_session(), message->backfill_number()},
                          now);
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
    if (!number) continue;
    sender_.on_written(*number);
    flow.sent_bytes += transmission->sample.bytes;
  }
  backfills_->send(now);
}

void LinkRouterComponent::answer(Time now) {
  for (const std::string& peer : backfills_->take_progressed())
    receiver_.ask_for_acknowledgement(peer, now);
  while (const auto due = receiver_.take_acknowledgement(now)) {
    auto message = std::make_shared<Acknowledgement>(to_message(due->acknowledgement));
    message->from_life(link_->self());
    message->to_life(lives_[due->peer]);
    const auto progress = backfills_->progress({due->peer, lives_[due->peer]});
    message->backfill_session(progress.session);
    message->backfill_number(progress.number);
    for (const auto& range : standing_.take_for(due->peer, now)) {
      message->requests().push_back(to_message(range));
    }
    (void)link_->send(acknowledgements_,
                      link_->pack(type_info<Acknowledgement>(), std::move(message)));
  }
}

}  // namespace tocsin

TOCSIN_COMPONENT(tocsin::LinkRouterComponent)
