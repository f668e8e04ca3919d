// SPDX-License-Identifier: Apache-2.0
// What this host sends; what it is sent is in backfill_given.cpp.
#include "backfill_link.hpp"

#include <algorithm>
#include <utility>

#include "backfill_messages.hpp"
#include "runtime/middleware/link_permissions.hpp"

namespace tocsin {
namespace {

using BackfillMessage = tocsin_msgs::msg::Backfill;

std::optional<FlowId> open_flow(LinkBus& link) {
  const auto stores = [](const auto& rules) {
    return std::any_of(rules.begin(), rules.end(),
                       [](const auto& rule) { return rule.second.stored || rule.second.logged; });
  };
  if (!stores(link.rules().all()) && !stores(link.rules().patterns())) return std::nullopt;
  Flow flow;
  flow.topic = backfill_topic;
  flow.type = type_info<BackfillMessage>().name;
  return link.open(flow, TrafficClass::low);
}

}  // namespace

BackfillLink::BackfillLink(const Parts& parts, const router::LinkRouterParams& params)
    : parts_(parts), flow_(open_flow(parts.link)), sender_(params) {
  if (flow_) parts_.sender.add_backfill_stream(*flow_);
}

void BackfillLink::add(FlowId on_link, const Flow& flow, const router::StreamRule& rule) {
  const std::uint64_t key = sample_log::stream_key(rule.name);
  keys_[on_link] = key;
  sent_[key].what = flow;
  parts_.store.add(logged_stream(rule.name, flow));
}

void BackfillLink::remove(FlowId on_link) {
  follow_fates();
  keys_.erase(on_link);
  logged_live_.erase(on_link);
}

void BackfillLink::offer(FlowId on_link, const CarriedSample& sample, Time now,
                         std::int64_t wall_ns) {
  const auto key = keys_.find(on_link);
  if (key == keys_.end()) return;
  const sample_log::SampleId id{key->second, sample.source, sample.sequence};
  sender_.offer(id);
  parts_.store.append({id, sample.sent_wall_ns, parts_.link.bytes_of(sample)}, now, wall_ns);
}

void BackfillLink::on_listener(const BackfillPeer& peer, Time now) {
  listeners_[peer.life] = peer;
  parts_.sender.set_wanted(peer.name, *flow_, true, now);
  if (!session_) begin_session();
}

void BackfillLink::on_lost(PeerId life) {
  listeners_.erase(life);
  early_.erase(std::remove_if(early_.begin(), early_.end(),
                              [life](const Arrived& one) { return one.peer.life == life; }),
               early_.end());
  if (session_ && session_->life == life) begin_session();
}

void BackfillLink::begin_session() {
  session_.reset();
  if (listeners_.empty()) return sender_.end_session();
  session_ = listeners_.begin()->second;
  sender_.begin_session();
}

void BackfillLink::follow_fates() {
  std::vector<sample_log::SampleId> crossed;
  for (const router::StoredFate& one : parts_.sender.take_fates()) {
    const auto logged = logged_live_.find(one.stream);
    const auto key = logged == logged_live_.end() ? keys_.find(one.stream) : logged;
    if (logged == logged_live_.end() && key == keys_.end()) continue;
    const sample_log::SampleId id{key->second, one.origin.source, one.origin.sequence};
    const bool was_waited_for = sender_.on_fate(id, one.fate);
    const bool is_news = logged != logged_live_.end() && one.fate == router::LiveFate::crossed;
    if (was_waited_for || is_news) crossed.push_back(id);
  }
  confirm(crossed);
}

void BackfillLink::confirm(const std::vector<sample_log::SampleId>& ids) {
  if (ids.empty()) return;
  std::vector<sample_log::SampleId> stored;
  std::vector<sample_log::SampleId> logged;
  for (const sample_log::SampleId& id : ids) (is_logged(id) ? logged : stored).push_back(id);
  parts_.store.confirm(std::move(stored));
  requests_.on_given(logged);
  parts_.history.confirm(std::move(logged));
}

void BackfillLink::follow(Time now, std::int64_t wall_ns) {
  follow_fates();
  take_early(now);
  parts_.store.note_given(std::exchange(live_, {}), std::nullopt);
  while (auto answer = parts_.store.take()) {
    std::visit([this](auto& what) { on(what); }, *answer);
  }
  follow_history(now, wall_ns);
  std::vector<sample_log::SampleId> stored;
  std::vector<sample_log::SampleId> logged;
  for (const auto& id : sender_.take_wanted()) (is_logged(id) ? logged : stored).push_back(id);
  parts_.store.read(std::move(stored));
  parts_.history.read(std::move(logged));
}

void BackfillLink::on(store_answer::Opened& answer) {
  for (const sample_log::LoggedStream& stream : answer.streams) {
    Described& described = sent_[sample_log::stream_key(stream.name)];
    if (described.what.topic.empty()) described.what = flow_of(stream);
  }
  for (const sample_log::SampleId& id : answer.waiting) sender_.recover(id);
  if (!answer.waiting.empty()) {
    parts_.log.info("{} stored samples of earlier runs are still to cross", answer.waiting.size());
  }
  receiver_.recover(answer.given);
}

void BackfillLink::on(store_answer::Appended& answer) {
  for (const auto& [id, logged] : answer.logged) sender_.on_logged(id, logged);
}

void BackfillLink::on(store_answer::Read& answer) {
  sender_.on_read(answer.asked, std::move(answer.read));
}

void BackfillLink::on(store_answer::Retired& answer) {
  for (const sample_log::SampleId& id : answer.ids) (void)sender_.on_retired(id);
}

void BackfillLink::on(store_answer::Problem& answer) { parts_.log.error("{}", answer.text); }

CarriedSample BackfillLink::packed(const router::BackfillBatch& batch) {
  auto message = std::make_shared<BackfillMessage>(to_message(batch));
  const Flow& flow = sent_.at(batch.stream).what;
  message->from_life(parts_.link.self());
  message->to_life(session_->life);
  message->topic(flow.topic);
  message->type(flow.type);
  message->user_data(flow.user_data);
  CarriedSample sample = parts_.link.pack(type_info<BackfillMessage>(), std::move(message));
  sample.sequence = ++batches_;
  return sample;
}

void BackfillLink::send(Time now) {
  while (session_ && parts_.sender.may_backfill(now)) {
    const auto batch = sender_.next(now, parts_.sender.capacity_bytes_per_s(now));
    if (!batch) return;
    const CarriedSample sample = packed(*batch);
    const router::Sample what{{0, sample.sequence, now}, sample.bytes, sample.content};
    parts_.sender.backfill(*flow_, what, now);
    if (const auto number = parts_.link.send(*flow_, sample)) parts_.sender.on_written(*number);
  }
}

void BackfillLink::on_progress(PeerId from, const router::BackfillProgress& progress, Time now) {
  if (fills(from)) confirm(sender_.on_progress(progress, now));
}

Time BackfillLink::deadline(Time now) const {
  Time next = sender_.deadline(now, parts_.sender.capacity_bytes_per_s(now));
  if (next <= now) next = parts_.sender.backfill_opens(now);
  for (const Arrived& one : early_) next = std::min(next, given_.at(key_of(one)).readers->end());
  return next;
}

void BackfillLink::report(tocsin_msgs::msg::LinkState& message) const {
  for (const auto& [key, counts] : sender_.counts()) {
    const auto described = sent_.find(key);
    if (described == sent_.end() || logged_streams_.count(key) != 0) continue;
    tocsin_msgs::msg::StoredTopic topic;
    topic.topic(described->second.what.topic);
    topic.stored(counts.stored);
    topic.backfilled(counts.backfilled);
    topic.expired(counts.expired);
    topic.refused(counts.refused);
    topic.waiting(static_cast<std::uint32_t>(counts.waiting));
    message.stored().push_back(std::move(topic));
  }
  add_fetches(message);
}

}  // namespace tocsin
