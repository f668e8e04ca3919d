// SPDX-License-Identifier: Apache-2.0
#include "backfill/backfill_incoming.hpp"

#include <algorithm>
#include <utility>

#include "backfill/backfill_messages.hpp"
#include "runtime/middleware/refused_names.hpp"

namespace tocsin {
namespace {

using BackfillMessage = tocsin_msgs::msg::Backfill;

/// For a topic that nobody reads.
constexpr Duration longest_delay = std::chrono::seconds(5);
/// Batches that wait for them: more than a sender has under way.
constexpr std::size_t most_early = 16;
/// Streams of all peers. A stranger would name more on a link that is not secured.
constexpr std::size_t most_streams = 1024;

/// By the name that the stream has at the peer, as stream_rule() makes it.
std::uint64_t key_of(const LinkPeer& peer, const BackfillMessage& message) {
  return router::BackfillReceiver::stream_key(peer.name,
                                              message.topic() + "|" + message.user_data());
}

}  // namespace

bool BackfillIncoming::on_live(const LinkPeer& peer, const router::StreamRule& rule,
                               const CarriedSample& sample) {
  const sample_log::SampleId id{router::BackfillReceiver::stream_key(peer.name, rule.name),
                                sample.source, sample.sequence};
  const bool is_new = receiver_.on_live(id);
  if (is_new) live_.push_back(id);
  return is_new;
}

void BackfillIncoming::on_batch(const LinkPeer& peer, const CarriedSample& sample, Instant at) {
  auto content = parts_.link.unpack(type_info<BackfillMessage>(), sample);
  const auto message = std::static_pointer_cast<const BackfillMessage>(std::move(content));
  if (!message || message->to_instance() != parts_.link.self() || !is_sound(*message)) return;
  const Batch batch{peer, message, key_of(peer, *message)};
  if (!parts_.link.rules().takes_later(message->topic())) {
    refuse("history of", message->topic(), peer.name, parts_.log);
    return take(batch, at);  // it is not delivered, and does not hold up what follows
  }
  if (streams_.size() >= most_streams && streams_.count(batch.key) == 0) return;
  if (stream_of(batch, at.now).readers.is_over(at.now)) return take(batch, at);
  if (early_.size() < most_early) early_.push_back(batch);  // else it is repeated
}

BackfillIncoming::Stream& BackfillIncoming::stream_of(const Batch& batch, Time now) {
  const auto known = streams_.find(batch.key);
  if (known != streams_.end()) return known->second;
  Flow flow;
  flow.topic = batch.message->topic();
  flow.type = batch.message->type();
  flow.user_data = batch.message->user_data();
  const FlowId on_host = parts_.link.offer(backfilled(flow));
  return streams_.insert({batch.key, Stream{flow, on_host, {longest_delay, now}}}).first->second;
}

void BackfillIncoming::on_local_reader(FlowId flow, Time now) {
  for (auto& entry : streams_) {
    if (entry.second.on_host == flow) entry.second.readers.on_reader(now);
  }
}

void BackfillIncoming::on_peer_gone(const LinkPeer& peer) {
  early_.erase(std::remove_if(early_.begin(), early_.end(),
                              [&](const Batch& one) { return one.peer.instance == peer.instance; }),
               early_.end());
}

void BackfillIncoming::follow(Instant at) {
  for (const Batch& batch : std::exchange(early_, {})) {
    if (streams_.at(batch.key).readers.is_over(at.now)) {
      take(batch, at);
    } else {
      early_.push_back(batch);
    }
  }
  parts_.store.note_delivered(std::exchange(live_, {}), std::nullopt);
}

void BackfillIncoming::take(const Batch& batch, Instant at) {
  const LinkPeer& peer = batch.peer;
  const auto batches =
      receiver_.on_batch(peer.name, peer.instance, to_batch(*batch.message, batch.key));
  std::vector<sample_log::SampleId> ids = std::exchange(live_, {});
  for (const router::BackfillBatch& one : batches) {
    deliver(one, at);
    for (const sample_log::LogEntry& entry : one.samples) ids.push_back(entry.id);
  }
  if (batches.empty()) return parts_.store.note_delivered(std::move(ids), std::nullopt);
  saving_[++last_token_] = {peer, receiver_.progress(peer.name, peer.instance)};
  parts_.store.note_delivered(std::move(ids), last_token_);
}

void BackfillIncoming::deliver(const router::BackfillBatch& batch, Instant at) {
  const auto known = streams_.find(batch.stream);
  if (known == streams_.end()) return;  // it was refused
  for (const sample_log::LogEntry& entry : batch.samples) {
    CarriedSample sample = parts_.link.sample_of(entry.bytes);
    if (!sample.content) continue;
    sample.source = entry.id.source;
    sample.sequence = entry.id.sequence;
    sample.sent_wall_ns = entry.sent_wall_ns;
    parts_.link.deliver(known->second.on_host, sample);
    parts_.arrivals.keep(known->second.what, sample, at);
  }
}

void BackfillIncoming::on_saved(std::uint64_t token, Time now) {
  const auto saving = saving_.find(token);
  if (saving == saving_.end()) return;
  const std::string& peer = saving->second.peer.name;
  parts_.link_receiver.ask_for_acknowledgement(peer, now);
  saved_[peer] = std::move(saving->second);
  saving_.erase(saving);
}

router::BackfillProgress BackfillIncoming::progress(const LinkPeer& peer) const {
  const auto found = saved_.find(peer.name);
  const bool known = found != saved_.end() && found->second.peer.instance == peer.instance;
  return known ? found->second.progress : router::BackfillProgress{};
}

Time BackfillIncoming::deadline() const {
  Time next = never;
  for (const Batch& one : early_) next = std::min(next, streams_.at(one.key).readers.end());
  return next;
}

}  // namespace tocsin
