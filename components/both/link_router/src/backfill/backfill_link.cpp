// SPDX-License-Identifier: Apache-2.0
#include "backfill/backfill_link.hpp"

#include <algorithm>
#include <functional>
#include <utility>
#include <variant>

#include "backfill/backfill_messages.hpp"
#include "foundation/hash.hpp"
#include "runtime/middleware/link_permissions.hpp"

namespace tocsin {
namespace {

/// Between what the stores keep up besides: ages, and what a power cut may take.
constexpr Duration keep_period = std::chrono::seconds(5);

std::function<void()> wake(Component& owner) {
  return [&owner] { owner.schedule().input_arrived(); };
}

}  // namespace

BackfillLink::BackfillLink(Component& owner, const LinkParts& parts, const Computer& computer,
                           const Params& params)
    : requests_(owner),
      owner_(owner),
      parts_(parts),
      store_(computer, params.store, wake(owner)),
      history_store_(computer, params.history, wake(owner)),
      arrivals_(parts.link, history_store_),
      sender_(params.link),
      history_({parts.link, history_store_, sender_, flows_, parts.log}),
      outgoing_(
          {parts.link, parts.streams, parts.sender, store_, sender_, history_, flows_, parts.log}),
      incoming_({parts.link, parts.receiver, store_, arrivals_, parts.log}),
      triggers_(make_triggers(owner, parts.link.rules().fetches())) {}

void BackfillLink::begin(Instant at) {
  if (at.now >= next_keep_) keep_stores(at);
  while (const auto message = requests_.take()) {
    const auto range = to_range(*message);
    if (!range) continue;
    standing_.on_request(*range, at.now);
    history_.request(*range, at.now);
  }
  if (!history_.knows_requests()) return;
  const auto resumed = history_.take_resumed_rules();
  for (const auto& trigger : triggers_) {
    if (resumed.count(trigger->rule().name) != 0) trigger->resume(at.now);
    if (const auto event = trigger->take()) fetch_around(*trigger, *event, at);
  }
}

/// What an earlier instance has left crosses though nobody writes it now.
void BackfillLink::keep_stores(Instant at) {
  next_keep_ = owner_.next_instant(keep_period, at.now);
  if (outgoing_.flow()) store_.open(at);
  if (history_.logs_any() || arrivals_.keeps_any()) history_store_.open(at);
  store_.keep(at.now);
  history_store_.keep(at.now);
}

void BackfillLink::fetch_around(const FetchTrigger& trigger, Time event, Instant at) {
  const FetchRule& rule = trigger.rule();
  const std::int64_t event_ns = at.wall_ns - (at.now - event).count();
  for (const std::string& topic : history_.topics()) {
    const bool is_wanted =
        std::any_of(rule.topics.begin(), rule.topics.end(),
                    [&topic](const std::string& one) { return one == topic || fits(one, topic); });
    if (!is_wanted) continue;
    const std::uint64_t id = hash_of(rule.name + " " + topic + " " + std::to_string(event_ns));
    const router::HistoryRange range{id, topic, event_ns - seconds(rule.before_s).count(),
                                     event_ns + seconds(rule.after_s).count()};
    if (history_.request({range, rule.name}, at)) continue;
    parts_.log.warn("{}: too much is being fetched; {} around this event is left out", rule.name,
                    topic);
  }
}

void BackfillLink::on_peer_gone(const LinkPeer& peer, Instant) {
  outgoing_.on_peer_gone(peer);
  incoming_.on_peer_gone(peer);
}

void BackfillLink::on_local_flow(const LocalFlow& flow, Instant) {
  if (flow.is_stored && flow.on_link) outgoing_.add(flow);
  if (flow.is_logged) history_.add(flow);
}

void BackfillLink::on_local_flow_gone(const LocalFlow& flow, Instant) {
  outgoing_.remove(flow);
  history_.remove(flow);
}

void BackfillLink::on_local(const LocalFlow& flow, const CarriedSample& sample, bool is_live,
                            Instant at) {
  history_.log(flow, sample, at);
  if (is_live) outgoing_.offer(flow, sample, at);
}

bool BackfillLink::takes(const std::string& topic) const { return topic == backfill_topic; }

void BackfillLink::on_remote(const RemoteFlow& flow, const link_event::LinkSample& event,
                             Instant at) {
  parts_.on_arrived(flow, event, at.now);  // a batch has numbers of its own
  store_.open(at);
  incoming_.on_batch(*parts_.peers.find(flow.peer), event.sample, at);
}

void BackfillLink::on_remote_reader(const LinkPeer& peer, FlowId flow, Time now) {
  if (outgoing_.flow() == flow) outgoing_.on_reader(peer, now);
}

void BackfillLink::on_acknowledgement(const LinkPeer& peer, const AcknowledgementMessage& message,
                                      Time now) {
  if (!outgoing_.is_for(peer)) return;
  for (const auto& request : message.requests()) {
    if (const auto range = to_range(request)) history_.request(*range, now);
  }
  outgoing_.on_progress({message.backfill_session(), message.backfill_number()}, now);
}

void BackfillLink::add_to(AcknowledgementMessage& message, const LinkPeer& peer, Time now) {
  const auto progress = incoming_.progress(peer);
  message.backfill_session(progress.session);
  message.backfill_number(progress.number);
  for (const auto& range : standing_.take_for(peer.name, now)) {
    message.requests().push_back(to_message(range));
  }
}

void BackfillLink::follow(Instant at) {
  outgoing_.follow_fates();
  incoming_.follow(at);
  take_answers(at);
  history_.follow(at);
  outgoing_.read_ahead();
}

void BackfillLink::take_answers(Instant at) {
  while (auto answer = store_.take()) {
    if (auto* const opened = std::get_if<store_answer::Opened>(&*answer)) {
      outgoing_.on_opened(*opened);
      incoming_.recover(opened->delivered);
    } else if (auto* const appended = std::get_if<store_answer::Appended>(&*answer)) {
      for (const auto& [id, logged] : appended->logged) sender_.on_logged(id, logged);
    } else if (auto* const read = std::get_if<store_answer::Read>(&*answer)) {
      sender_.on_read(read->asked, std::move(read->read));
    } else if (auto* const retired = std::get_if<store_answer::Retired>(&*answer)) {
      for (const sample_log::SampleId& id : retired->ids) sender_.on_retired(id);
    } else if (auto* const saved = std::get_if<store_answer::Saved>(&*answer)) {
      incoming_.on_saved(saved->token, at.now);
    } else if (auto* const problem = std::get_if<store_answer::Problem>(&*answer)) {
      parts_.log.error("{}", problem->text);
    }
  }
}

void BackfillLink::add_to(tocsin_msgs::msg::LinkState& message, Time) const {
  outgoing_.add_to(message);
  history_.add_to(message);
}

Time BackfillLink::deadline(Time now) const {
  return std::min({outgoing_.deadline(now), incoming_.deadline(), next_keep_});
}

bool BackfillLink::on_live(const LinkPeer& peer, const RemoteFlow& flow,
                           const CarriedSample& sample) {
  return incoming_.on_live(peer, flow.rule, sample);
}

void BackfillLink::on_delivery(const Flow& what, const CarriedSample& sample, Instant at) {
  arrivals_.keep(what, sample, at);
}

}  // namespace tocsin
