// SPDX-License-Identifier: Apache-2.0
// What acknowledgements tell a LinkSender.
#include <algorithm>

#include "link_router/link_sender.hpp"

namespace tocsin::router {

LinkSender::Peer* LinkSender::peer_of(PeerIndex index) {
  for (auto& entry : peers_) {
    if (entry.second.index == index) return &entry.second;
  }
  return nullptr;
}

void LinkSender::on_acknowledgement(const std::string& peer,
                                    const LinkAcknowledgement& acknowledgement, Time now) {
  const auto known = peers_.find(peer);
  if (known == peers_.end()) return;
  Peer& from = known->second;
  // An older or repeated one is as true as when it was made, so that no count is remembered.
  const bool was_silent = from.estimator.is_silent(now);
  const auto settlements = log_.on_acknowledgement(from.index, acknowledgement);
  const bool came = std::any_of(settlements.begin(), settlements.end(),
                                [](const Settlement& one) { return one.came; });
  apply(settlements, now);
  if (!came) return;
  if (log_.count_under_way(from.index, 0) == 0) from.estimator.on_all_settled();
  if (!was_silent) return;
  from.estimator.start_over(now);
  revive(now);
}

void LinkSender::apply(const std::vector<Settlement>& settlements, Time now) {
  for (const Settlement& one : settlements) apply(one, now);
  if (!settlements.empty()) conclude_all(now);
}

void LinkSender::apply(const Settlement& settlement, Time now) {
  Peer* const peer = peer_of(settlement.peer);
  if (peer == nullptr) return;
  if (!settlement.came) return peer->estimator.on_lost();
  const Duration delay =
      peer->estimator.on_received({settlement.cost, settlement.sent, settlement.expected,
                                   settlement.arrived, settlement.is_exact},
                                  now);
  SentSample& sent = *settlement.sample;
  ClassCounts& count = counts(sent.traffic_class);
  if (settlement.is_exact) count.delay = delay;
  const auto place = std::find(sent.missing.begin(), sent.missing.end(), settlement.peer);
  if (place == sent.missing.end()) return;
  sent.missing.erase(place);
  sent.came = true;
  sent.repaired = sent.repaired || settlement.sent != sent.first_sent;
  sent.late = sent.late || settlement.sent + delay - sent.offered > seconds(params_.late_after_s);
  if (sent.fate != SentSample::Fate::lost || !sent.missing.empty()) return;
  // It was given up too early.
  if (sent.counted) --count.lost;
  count_delivered(sent);
}

void LinkSender::count_delivered(SentSample& sent) {
  sent.fate = SentSample::Fate::delivered;
  tell_fate(sent, LiveFate::crossed);
  if (!sent.counted) return;
  ClassCounts& count = counts(sent.traffic_class);
  ++count.delivered;
  if (sent.late) ++count.late;
  if (sent.repaired) ++count.repaired;
}

void LinkSender::conclude(SentSample& sent) {
  if (sent.missing.empty() && sent.came) return count_delivered(sent);
  const bool unwanted = sent.missing.empty();
  sent.fate = unwanted ? SentSample::Fate::unwanted : SentSample::Fate::lost;
  tell_fate(sent, LiveFate::did_not_cross);
  if (!sent.counted) return;
  ClassCounts& count = counts(sent.traffic_class);
  ++(unwanted ? count.unwanted : count.lost);
}

void LinkSender::conclude_all(Time now) {
  for (auto it = open_.begin(); it != open_.end();) {
    SentSample& sent = **it;
    const bool is_open = !sent.missing.empty() && (sent.under_way > 0 || can_repair(sent, now));
    if (is_open) {
      ++it;
      continue;
    }
    conclude(sent);
    it = open_.erase(it);
  }
}

void LinkSender::revive(Time now) {
  for (const SentSamplePtr& sent : open_) {
    sent->repair_at = std::min(sent->repair_at, now);
    sent->transmissions = std::min(sent->transmissions, 1U);
  }
}

}  // namespace tocsin::router
