// SPDX-License-Identifier: Apache-2.0
// What peers fill in, and what of it the host is given.
#include <algorithm>
#include <utility>

#include "backfill_link.hpp"
#include "backfill_messages.hpp"
#include "runtime/middleware/refused_names.hpp"

namespace tocsin {
namespace {

using BackfillMessage = tocsin_msgs::msg::Backfill;

/// For a topic that nobody reads.
constexpr Duration longest_delay = std::chrono::seconds(5);
/// Batches that wait for them: more than a sender has under way.
constexpr std::size_t most_early = 16;
/// Streams of all peers. A stranger would name more on a link that is not secured.
constexpr std::size_t most_given = 1024;

/// The name that the stream has at the peer, as stream_rule() makes it.
std::string stream_name(const BackfillMessage& message) {
  return message.topic() + "|" + message.user_data();
}

}  // namespace

bool BackfillLink::on_live(const std::string& peer, const router::StreamRule& rule,
                           const CarriedSample& sample) {
  const sample_log::SampleId id{router::BackfillReceiver::stream_key(peer, rule.name),
                                sample.source, sample.sequence};
  const bool is_new = receiver_.on_live(id);
  if (is_new) live_.push_back(id);
  return is_new;
}

std::uint64_t BackfillLink::key_of(const Arrived& batch) {
  return router::BackfillReceiver::stream_key(batch.peer.name, stream_name(*batch.message));
}

void BackfillLink::on_batch(const BackfillPeer& peer, const CarriedSample& sample, Time now) {
  auto content = parts_.link.unpack(type_info<BackfillMessage>(), sample);
  const Arrived batch{peer, std::static_pointer_cast<const BackfillMessage>(std::move(content))};
  const BackfillMessage* const message = batch.message.get();
  if (message == nullptr || message->to_life() != parts_.link.self() || !is_sound(*message)) return;
  if (!parts_.link.rules().takes_later(message->topic())) {
    refuse("history of", message->topic(), peer.name, parts_.log);
    return take(batch, now);  // it is not given, and does not hold up what follows
  }
  if (given_.size() >= most_given && given_.count(key_of(batch)) == 0) return;
  Described& described = given_[key_of(batch)];
  Flow& flow = described.what;
  flow.topic = message->topic();
  flow.type = message->type();
  flow.user_data = message->user_data();
  if (!described.on_host) {
    described.on_host = parts_.link.offer(backfilled(flow));
    described.readers.emplace(longest_delay, now);
  }
  if (described.readers->is_over(now)) return take(batch, now);
  if (early_.size() < most_early) early_.push_back(batch);  // else it comes again
}

void BackfillLink::on_host_listens(FlowId on_host, Time now) {
  for (auto& entry : given_) {
    if (entry.second.on_host == on_host) entry.second.readers->on_reader(now);
  }
}

void BackfillLink::take_early(Time now) {
  for (const Arrived& batch : std::exchange(early_, {})) {
    if (given_.at(key_of(batch)).readers->is_over(now)) {
      take(batch, now);
    } else {
      early_.push_back(batch);
    }
  }
}

void BackfillLink::take(const Arrived& batch, Time now) {
  const BackfillPeer& peer = batch.peer;
  const auto batches =
      receiver_.on_batch(peer.name, peer.life, to_batch(*batch.message, key_of(batch)));
  std::vector<sample_log::SampleId> ids = std::exchange(live_, {});
  for (const router::BackfillBatch& one : batches) {
    give(one, now);
    for (const sample_log::LogEntry& entry : one.samples) ids.push_back(entry.id);
  }
  if (batches.empty()) return parts_.store.note_given(std::move(ids), std::nullopt);
  saving_[++last_token_] = {peer, receiver_.progress(peer.name, peer.life)};
  parts_.store.note_given(std::move(ids), last_token_);
}

void BackfillLink::give(const router::BackfillBatch& batch, Time now) {
  const auto known = given_.find(batch.stream);
  if (known == given_.end()) return;  // was refused
  const Described& described = known->second;
  for (const sample_log::LogEntry& entry : batch.samples) {
    CarriedSample sample = parts_.link.sample_of(entry.bytes);
    if (!sample.content) continue;
    sample.source = entry.id.source;
    sample.sequence = entry.id.sequence;
    sample.sent_wall_ns = entry.sent_wall_ns;
    parts_.link.give(*described.on_host, sample);
    parts_.arrivals.keep(described.what, sample, now);
  }
}

void BackfillLink::on(store_answer::Saved& answer) {
  const auto saving = saving_.find(answer.token);
  if (saving == saving_.end()) return;
  progressed_.insert(saving->second.peer.name);
  saved_[saving->second.peer.name] = std::move(saving->second);
  saving_.erase(saving);
}

router::BackfillProgress BackfillLink::progress(const BackfillPeer& peer) const {
  const auto found = saved_.find(peer.name);
  const bool known = found != saved_.end() && found->second.peer.life == peer.life;
  return known ? found->second.progress : router::BackfillProgress{};
}

std::set<std::string> BackfillLink::take_progressed() { return std::exchange(progressed_, {}); }

}  // namespace tocsin
