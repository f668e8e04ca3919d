// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_sender.hpp"

#include <algorithm>
#include <cassert>
#include <memory>
#include <utility>

#include "link_router/link_constants.hpp"
#include "link_router/sent_pieces.hpp"
namespace tocsin::router {
namespace {

/// Sources of one stream that are remembered; then the one silent for longest goes.
constexpr std::size_t most_sources = 64;

Time later(Time time, Duration by) { return by > never - time ? never : time + by; }

Duration patience_of(const LinkRouterParams& params) {
  return seconds(params.hold_backlog_s) + acknowledgement_delay + acknowledgement_period;
}

}  // namespace

LinkSender::LinkSender(const LinkRouterParams& params)
    : params_(params),
      queue_(static_cast<std::size_t>(params.queue_bytes)),
      log_(patience_of(params)),
      pacer_(params, peers_, log_),
      retransmitter_(params, peers_, pacer_, gate_),
      adaptation_(params) {
  check(params);
  set_vehicles(static_cast<unsigned>(params.vehicles));
}

void LinkSender::begin(Time now) {
  if (watch_.begins(now)) peers_.on_frozen(now);
  follow_shared_air();
}

void LinkSender::add_stream(StreamId stream, const StreamRule& rule) {
  assert(rule.depth > 0);
  const bool is_new = streams_.try_emplace(stream, Stream{rule, {}, false}).second;
  assert(is_new);
  if (is_new && rule.adaptive) adaptation_.add_stream(stream);
}

void LinkSender::remove_stream(StreamId stream) {
  const auto found = streams_.find(stream);
  if (found == streams_.end()) return;
  const StreamRule& rule = found->second.rule;
  for (const auto& waiting : {queue_.take_stream(stream), gate_.take_stream(stream)}) {
    for (const Waiting& one : waiting) counters_.on_dropped(one, rule, DropReason::removed);
  }
  for (const SentSamplePtr& sent : retransmitter_.end_stream(stream)) {
    counters_.end(sent->whole ? *sent->whole : *sent);
  }
  const auto is_of_stream = [stream](const auto& sent) { return sent->stream == stream; };
  burst_.erase(std::remove_if(burst_.begin(), burst_.end(), is_of_stream), burst_.end());
  copies_.erase(std::remove_if(copies_.begin(), copies_.end(), is_of_stream), copies_.end());
  streams_.erase(found);
  adaptation_.forget_stream(stream);
  counters_.forget_stream(stream);
  log_.forget_stream(stream);
  peers_.forget_stream(stream);
}

void LinkSender::on_peer(const std::string& peer, InstanceId instance, Time now) {
  const LinkedPeer* const known = peers_.find(peer);
  if (known != nullptr && known->instance == instance) return;
  forget_peer(peer, now);
  peers_.add(peer, instance);
}

void LinkSender::forget_peer(const std::string& peer, Time now) {
  const LinkedPeer* const known = peers_.find(peer);
  if (known == nullptr) return;
  const PeerIndex index = known->index;
  peers_.remove(peer);
  apply(log_.forget_peer(index), now);
  retransmitter_.forget_reader(index, std::nullopt);
  conclude(now);
}

void LinkSender::set_wanted(const std::string& peer, StreamId stream, bool wanted, Time now) {
  LinkedPeer* const to = peers_.find(peer);
  const auto found = streams_.find(stream);
  if (to == nullptr || found == streams_.end()) return;
  if (!wanted) {
    to->wanted.erase(stream);
    retransmitter_.forget_reader(to->index, stream);
    return conclude(now);
  }
  if (!to->wanted.insert(stream).second) return;
  for (auto& entry : found->second.sources) {
    entry.second.compressed.on_new_reader();
    const SentSamplePtr& newest = entry.second.newest;
    if (!newest || now > newest->expires) continue;
    const auto copy = std::make_shared<SentSample>(*newest);
    copy->sample = copy->plain;  // the peer has no base
    copy->cost = wire_cost(copy->sample.bytes);
    copy->missing = {to->index};
    copy->under_way = 0;
    copy->repair_at = now;
    copy->transmissions = 0;
    copy->counted = false;
    copy->superseded = false;
    copy->fate = SentSample::Fate::open;
    for (const SentSamplePtr& piece : pieces_of(copy)) retransmitter_.add(piece);
  }
}

LinkSender::Source& LinkSender::source_of(Stream& stream, const Sample& sample) {
  const auto [place, is_new] = stream.sources.try_emplace(sample.origin.source);
  if (is_new && stream.sources.size() > most_sources) {
    auto oldest = stream.sources.end();
    for (auto it = stream.sources.begin(); it != stream.sources.end(); ++it) {
      if (it == place) continue;
      if (oldest == stream.sources.end() || it->second.sent < oldest->second.sent) oldest = it;
    }
    stream.sources.erase(oldest);
  }
  return place->second;
}

void LinkSender::offer(StreamId stream, const Sample& sample, Time now) {
  const auto found = streams_.find(stream);
  assert(found != streams_.end());
  const StreamRule& rule = found->second.rule;
  const WireCost cost = wire_cost(sample.bytes);
  const Waiting waiting{stream, sample, cost, now, later(now, rule.lifespan)};
  if (rule.on_demand && !is_wanted(stream)) {
    if (rule.durable) (void)make_sent(waiting);  // for who begins to read
    return;
  }
  counters_.on_offered(stream, rule.traffic_class);
  adaptation_.on_offered(stream, cost, now);
  gate_.stops(rule.while_paused) ? hold(rule, waiting) : enqueue(rule, waiting);
}

void LinkSender::enqueue(const StreamRule& rule, const Waiting& waiting) {
  drop(queue_.add(rule.traffic_class, rule.depth, waiting));
}

void LinkSender::hold(const StreamRule& rule, const Waiting& waiting) {
  const auto dropped = gate_.hold(rule.while_paused, waiting);
  if (dropped) counters_.on_dropped(*dropped, rule, DropReason::paused);
}

void LinkSender::set_paused(bool paused, Time now) {
  if (paused == gate_.is_paused()) return;
  gate_.set_paused(paused);
  for (auto& [id, stream] : streams_) {
    if (stream.rule.while_paused == WhilePaused::send) continue;
    if (paused) {
      for (const Waiting& one : queue_.take_stream(id)) hold(stream.rule, one);
    } else {
      for (const Waiting& one : gate_.take_stream(id)) enqueue(stream.rule, one);
    }
  }
  drop(queue_.take_expired(now));
}

void LinkSender::drop(const std::vector<Dropped>& dropped) {
  for (const Dropped& one : dropped) {
    counters_.on_dropped(one.waiting, streams_.at(one.waiting.stream).rule, one.reason);
  }
}

std::optional<Transmission> LinkSender::next(Time now) {
  if (!burst_.empty()) {
    const SentSamplePtr piece = burst_.front();
    burst_.pop_front();
    return transmit(piece, now);
  }
  if (!copies_.empty()) {
    const SentSamplePtr piece = copies_.front();
    copies_.pop_front();
    return put_copy(piece, now);
  }
  choose_path(now);
  apply(log_.give_up_overdue(now), now);
  drop(queue_.take_expired(now));
  conclude(now);
  adaptation_.follow(peers_, now);
  for (const TrafficClass traffic_class : traffic_classes) {
    if (auto one = next_of(traffic_class, now)) return one;
  }
  note_share_missed(now);
  return std::nullopt;
}

void LinkSender::note_share_missed(Time now) {
  const bool waits = peers_.waits_for_share(now) && has_waiting();
  share_missed_ = share_missed_ || waits || adaptation_.is_bound_by_share();
}

std::optional<Transmission> LinkSender::next_of(TrafficClass traffic_class, Time now) {
  const SentSamplePtr lost = retransmitter_.due_with_bulk(traffic_class, now);
  const bool has_new = queue_.samples(traffic_class) > 0;
  if (lost || has_new) {
    const std::size_t packets = pacer_.packets_allowed(traffic_class, now);
    const bool is_first = !has_new || !peers_.is_silent(now);  // what finds the peer alive is fresh
    if (lost && is_first && packets > bulk_packets) return transmit(lost, now);
    while (const auto waiting = queue_.take_first(traffic_class, packets)) {
      if (can_arrive(*waiting, now)) return send_first(*waiting, now);
      drop({{*waiting, DropReason::expired}});
    }
  }
  if (const auto sent = retransmitter_.due(traffic_class, now)) return transmit(sent, now);
  return std::nullopt;
}

bool LinkSender::can_arrive(const Waiting& waiting, Time now) const {
  if (waiting.expires == never) return true;
  const double capacity_bytes_per_s = peers_.capacity_bytes_per_s(now);
  const Duration takes = seconds(static_cast<double>(waiting.cost.bytes) / capacity_bytes_per_s);
  // A fresh one always goes, or a capacity that is believed too small is never measured.
  const Duration life = waiting.expires - waiting.offered;
  // It may have waited long for its share of the air, and then waits for the others.
  return waiting.expires - now - peers_.shared_delay() >= std::min(takes, life / 4);
}

bool LinkSender::has_due_with_bulk(Time now) const {
  return std::any_of(traffic_classes.begin(), traffic_classes.end(), [&](TrafficClass one) {
    return retransmitter_.due_with_bulk(one, now) != nullptr;
  });
}

Transmission LinkSender::send_first(const Waiting& waiting, Time now) {
  const SentSamplePtr sent = make_sent(waiting);
  Stream& stream = streams_.at(waiting.stream);
  counters_.on_first_sent(*sent);
  source_of(stream, sent->sample).sent = now;
  retransmitter_.supersede(*sent, stream.rule.depth);
  compress(*sent);
  const auto pieces = in_pieces(sent);
  burst_.assign(pieces.begin() + 1, pieces.end());
  if (goes_by_both(*sent, now)) copies_.assign(pieces.begin(), pieces.end());
  return transmit(pieces.front(), now);
}

std::vector<SentSamplePtr> LinkSender::pieces_of(const SentSamplePtr& sent) const {
  // What is stored is acknowledged whole or not at all: nothing else follows in another way.
  return cut(sent, sent->is_stored ? 0 : largest_piece_);
}

std::vector<SentSamplePtr> LinkSender::in_pieces(const SentSamplePtr& sent) {
  auto pieces = pieces_of(sent);
  const std::uint64_t burst = pieces.size() > 1 ? ++bursts_ : 0;
  for (const SentSamplePtr& piece : pieces) {
    piece->burst = burst;
    retransmitter_.add(piece);
  }
  return pieces;
}

SentSamplePtr LinkSender::make_sent(const Waiting& waiting) {
  Stream& stream = streams_.at(waiting.stream);
  const StreamRule& rule = stream.rule;
  const auto sent = std::make_shared<SentSample>();
  sent->stream = waiting.stream;
  sent->traffic_class = rule.traffic_class;
  sent->sample = waiting.sample;
  sent->plain = waiting.sample;
  sent->cost = waiting.cost;
  sent->offered = waiting.offered;
  sent->expires = waiting.expires;
  sent->while_paused = rule.while_paused;
  sent->is_repaired = rule.repaired;
  sent->is_stored = rule.stored;
  sent->missing = peers_.readers_of(waiting.stream);
  if (rule.durable) {
    source_of(stream, sent->sample).newest = sent;
  } else if (sent->expires == never) {
    sent->expires = waiting.offered + repair_lifespan;
  }
  return sent;
}

void LinkSender::compress(SentSample& sent) {
  Stream& stream = streams_.at(sent.stream);
  if (!stream.rule.compressed || !compress_ || largest_piece_ == 0) return;
  sent.sample = source_of(stream, sent.plain).compressed.send(sent.plain, compress_);
  sent.cost = wire_cost(sent.sample.bytes);
}

void LinkSender::note_base(const SentSample& sent) {
  if (!sent.sample.coding.is_compressed || sent.fate != SentSample::Fate::delivered) return;
  const auto stream = streams_.find(sent.stream);
  if (stream == streams_.end()) return;
  const auto source = stream->second.sources.find(sent.plain.origin.source);
  if (source != stream->second.sources.end()) source->second.compressed.on_delivered(sent.plain);
}

Transmission LinkSender::transmit(const SentSamplePtr& sent, Time now) {
  const bool was_sent = sent->transmissions > 0;
  sent->path = was_sent ? path_of_repair(*sent, now) : peers_.path();
  const Duration expected = expected_wait(*sent, now);
  Transmission one = put(sent, now);
  retransmitter_.schedule(*sent, expected, now);
  const Stream& stream = streams_.at(sent->stream);
  if (stream.is_backfill) return one;
  const WireCost& cost = sent->cost;
  one.repair = was_sent;
  if (!stream.rule.adaptive) adaptation_.on_other(cost, now);
  if (was_sent || !sent->counted) {
    counters_.on_repair(sent->traffic_class, cost.bytes);
    sent->mends_with_bulk() ? retransmitter_.note_with_bulk(cost.bytes, now)
                            : retransmitter_.spend(cost.bytes, now);
  }
  return one;
}

Transmission LinkSender::put(const SentSamplePtr& sent, Time now) {
  const WireCost& cost = sent->cost;
  const PathIndex path = sent->path;
  const bool of_share = !policy_of(sent->traffic_class).passes_backlog;
  Transmission one{sent->stream,
                   sent->sample,
                   sent->piece,
                   sent->piece.size(sent->plain.bytes),
                   false,
                   path,
                   {0, path, now, cost, 0, sent, {}}};
  if (sent->burst != 0 && sent->transmissions == 0) {
    one.record.cost = sent->burst_cost;
    one.record.burst = sent->burst;
  }
  for (auto& entry : peers_.all()) {
    LinkedPeer& peer = entry.second;
    if (peer.wanted.count(sent->stream) == 0) continue;
    const Time leaves = peer.estimators[path].on_sent(cost, now, of_share);
    if (of_share && path == 0) of_share_.add(cost.bytes, now);
    one.record.copies.push_back({peer.index, leaves, false, false});
  }
  pacer_.on_sent(now);
  sent_by_[path] = now;
  return one;
}

Transmission LinkSender::put_copy(const SentSamplePtr& sent, Time now) {
  sent->path = other_path(sent->path);
  Transmission one = put(sent, now);
  one.repair = true;
  counters_.on_repair(sent->traffic_class, sent->cost.bytes);
  return one;
}

bool LinkSender::goes_by_both(const SentSample& sent, Time now) const {
  if (!peers_.has_two_paths()) return false;
  const Time other_sent = sent_by_[other_path(peers_.path())];
  if (other_sent == Time::min() || now - other_sent >= path_probe_period) {
    return sent.cost.packets == 1;
  }
  if (streams_.at(sent.stream).rule.paths != PathUse::both) return false;
  const PathHealth better = peers_.health(peers_.path(), now);
  return better.is_silent || better.loss > poor_loss;
}

PathIndex LinkSender::path_of_repair(const SentSample& sent, Time now) const {
  if (!peers_.has_two_paths() || streams_.at(sent.stream).rule.paths == PathUse::best) {
    return peers_.path();
  }
  const PathIndex other = other_path(sent.path);
  const bool answers = !peers_.health(other, now).is_silent;
  return answers || peers_.health(sent.path, now).is_silent ? other : sent.path;
}

Duration LinkSender::expected_wait(const SentSample& sent, Time now) const {
  Duration expected{0};
  for (const auto& entry : peers_.all()) {
    if (entry.second.wanted.count(sent.stream) == 0) continue;
    const LinkEstimator& estimator = entry.second.estimators[sent.path];
    expected = std::max(expected, std::min(estimator.backlog(now), estimator.expected_delay()));
    if (peers_.vehicles() > 1 && sent.path == 0) {
      expected = std::max(expected, estimator.expected_answer() - seconds(params_.repair_first_s));
    }
  }
  return expected;
}

Duration LinkSender::acknowledgement_period() const {
  return std::clamp(peers_.shared_delay(), router::acknowledgement_period,
                    acknowledgement_period_busy);
}

void LinkSender::follow_shared_air() {
  log_.set_patience(std::max(patience_of(params_), peers_.shared_answer()));
}

void LinkSender::choose_path(Time now) {
  if (!peers_.has_two_paths()) return;
  const bool was_silent = peers_.health(peers_.path(), now).is_silent;
  if (!peers_.choose_path(now)) return;
  adaptation_.on_other_path();
  if (was_silent) retransmitter_.revive_elsewhere(now);
}

void LinkSender::on_written(const Transmission& transmission, TransmissionNumber number) {
  DeliveryLog::Record record = transmission.record;
  record.number = number;
  log_.add(std::move(record));
}

bool LinkSender::has_waiting() const {
  return std::any_of(traffic_classes.begin(), traffic_classes.end(),
                     [this](TrafficClass one) { return queue_.samples(one) > 0; });
}

Time LinkSender::deadline(Time now) const {
  const Time next =
      std::min({queue_.next_expiry(), log_.next_overdue(), retransmitter_.deadline(now)});
  if (!has_waiting() && !has_due_with_bulk(now)) return next;
  const Time opens = pacer_.opens(now);
  return opens > now ? std::min(next, opens) : next;
}

void LinkSender::on_acknowledgement(const std::string& peer,
                                    const LinkAcknowledgement& acknowledgement, Time now) {
  LinkedPeer* const from = peers_.find(peer);
  if (from == nullptr) return;
  // An older or repeated one is as true as when it was made, so that no count is remembered.
  std::array<bool, most_paths> was_silent{};
  for (PathIndex path = 0; path < most_paths; ++path) {
    was_silent[path] = from->estimators[path].is_silent(now);
  }
  const auto settlements = log_.on_acknowledgement(from->index, acknowledgement);
  apply(settlements, now);
  for (PathIndex path = 0; path < most_paths; ++path) {
    const bool received =
        std::any_of(settlements.begin(), settlements.end(),
                    [path](const Settlement& one) { return one.received && one.path == path; });
    if (received) on_arrivals(*from, path, was_silent[path], now);
  }
}

void LinkSender::on_arrivals(LinkedPeer& peer, PathIndex path, bool was_silent, Time now) {
  LinkEstimator& estimator = peer.estimators[path];
  if (!log_.is_under_way(peer.index, path)) estimator.on_all_settled();
  if (!was_silent) return;
  estimator.start_over(now);
  const bool was_all_silent = path == peers_.path() || peers_.is_silent(now);
  if (was_all_silent) retransmitter_.revive(now);
}

void LinkSender::apply(const std::vector<Settlement>& settlements, Time now) {
  for (const Settlement& one : settlements) apply(one, now);
  if (!settlements.empty()) conclude(now);
}

void LinkSender::apply(const Settlement& settlement, Time now) {
  LinkedPeer* const peer = peers_.find(settlement.peer);
  if (peer == nullptr) return;
  LinkEstimator& estimator = peer->estimators[settlement.path];
  SentSample& sent = *settlement.sample;
  if (!settlement.received) {
    // Where nothing bounds the repairs, at growing intervals: nobody may know of the arrival.
    const bool at_once = !sent.is_repaired || sent.transmissions == 1;
    if (sent.mends_with_bulk() && sent.under_way == 0 && at_once) sent.repair_at = now;
    return estimator.on_lost();
  }
  const Duration delay =
      estimator.on_received({settlement.cost, settlement.sent, settlement.expected,
                             settlement.arrived, settlement.is_exact, settlement.burst},
                            now);
  if (settlement.is_exact && sent.piece.is_last()) counters_.on_delay(sent.traffic_class, delay);
  const auto place = std::find(sent.missing.begin(), sent.missing.end(), settlement.peer);
  if (place == sent.missing.end()) return;
  sent.missing.erase(place);
  take_delivery(sent, settlement, delay);
  const bool was_given_up = sent.fate == SentSample::Fate::lost && sent.missing.empty();
  if (!was_given_up) return;
  if (!sent.whole) return counters_.revoke_loss(sent);
  if (revoke_loss(sent)) counters_.revoke_loss(*sent.whole);
}

void LinkSender::take_delivery(SentSample& sent, const Settlement& settlement, Duration delay) {
  sent.received = true;
  if (sent.whole) sent.whole->arrives = true;
  sent.repaired = sent.repaired || settlement.sent != sent.first_sent;
  sent.late = sent.late || settlement.sent + delay - sent.offered > late_after;
}

void LinkSender::conclude(Time now) {
  for (const SentSamplePtr& sent : retransmitter_.conclude(now)) {
    if (!sent->whole) {
      counters_.conclude(*sent);
      note_base(*sent);
      continue;
    }
    if (!conclude_piece(*sent)) continue;
    SentSample& whole = *sent->whole;
    counters_.conclude(whole);
    note_base(whole);
    const auto stream = streams_.find(whole.stream);
    if (whole.fate != SentSample::Fate::delivered || stream == streams_.end()) continue;
    retransmitter_.end_older(whole, stream->second.rule.depth);
  }
}

void LinkSender::add_backfill_stream(StreamId stream) {
  StreamRule rule;
  rule.name = "backfill";
  add_stream(stream, rule);
  streams_.at(stream).is_backfill = true;
}

bool LinkSender::may_backfill(Time now) const {
  return !gate_.is_paused() && !has_waiting() && pacer_.is_idle(now);
}

Time LinkSender::backfill_opens(Time now) const {
  if (may_backfill(now)) return now;
  return gate_.is_paused() ? never : pacer_.idle_from(now);
}

std::vector<Transmission> LinkSender::backfill(StreamId stream, const Sample& sample, Time now) {
  const auto sent = std::make_shared<SentSample>();
  sent->stream = stream;
  sent->traffic_class = streams_.at(stream).rule.traffic_class;
  sent->sample = sample;
  sent->plain = sample;
  sent->cost = wire_cost(sample.bytes);
  sent->offered = now;
  sent->expires = now;
  sent->counted = false;
  sent->superseded = true;
  sent->missing = peers_.readers_of(stream);
  std::vector<Transmission> all;
  for (const SentSamplePtr& piece : in_pieces(sent)) all.push_back(transmit(piece, now));
  return all;
}

std::vector<StreamBudget> LinkSender::budgets(Time now) const {
  const bool is_full = peers_.backlog(now) > seconds(params_.hold_backlog_s);
  return adaptation_.budgets([&](StreamId stream) { return is_full || queue_.has(stream); });
}

LinkStateValues LinkSender::state(Time now) const {
  LinkStateValues values;
  values.classes = counters_.classes();
  for (const TrafficClass traffic_class : traffic_classes) {
    ClassCounts& counts = values.classes[index_of(traffic_class)];
    counts.waiting_samples = queue_.samples(traffic_class);
    counts.waiting_bytes = queue_.bytes(traffic_class);
  }
  for (const auto& [id, stream] : streams_) {
    const LinkGate::Held held = gate_.held(id);
    ClassCounts& counts = values.classes[index_of(stream.rule.traffic_class)];
    counts.waiting_samples += held.samples;
    counts.waiting_bytes += held.bytes;
  }
  const LinkEstimator* const slowest = peers_.slowest(now);
  values.capacity_bytes_per_s = peers_.capacity_bytes_per_s(now);
  values.capacity_measured = slowest != nullptr && slowest->is_capacity_measured();
  values.backlog = peers_.backlog(now);
  values.scale = adaptation_.scale();
  values.repair_share = retransmitter_.share(now);
  values.paused = gate_.is_paused();
  for (const auto& entry : peers_.all()) {
    ++(peers_.is_silent(entry.second, now) ? values.silent_peers : values.live_peers);
    values.loss = std::max(values.loss, entry.second.estimators[peers_.path()].loss());
  }
  if (peers_.has_two_paths()) values.paths = {path_values(0, now), path_values(1, now)};
  return values;
}

PathValues LinkSender::path_values(PathIndex path, Time now) const {
  const PathHealth health = peers_.health(path, now);
  PathValues values;
  values.chosen = path == peers_.path();
  values.silent = health.is_silent;
  values.capacity_bytes_per_s = peers_.capacity_bytes_per_s(path, now);
  values.backlog = peers_.backlog(path, now);
  values.loss = health.loss;
  if (health.is_known) values.delay = health.delay;
  return values;
}

}  // namespace tocsin::router
