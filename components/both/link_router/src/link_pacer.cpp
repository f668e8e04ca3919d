// SPDX-License-Identifier: Apache-2.0
#include "link_router/link_pacer.hpp"

#include <algorithm>
#include <limits>

#include "link_router/link_constants.hpp"
namespace tocsin::router {
namespace {

constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();

}  // namespace

bool LinkPacer::bulk_may_go(Time now) const {
  if (peers_.is_silent(now)) return false;
  if (peers_.backlog(now) > seconds(params_.bulk_backlog_s)) return false;
  const auto most = static_cast<std::size_t>(params_.bulk_under_way);
  const PathIndex path = peers_.path();
  return std::all_of(peers_.all().begin(), peers_.all().end(), [&](const auto& entry) {
    const LinkedPeer& peer = entry.second;
    return peer.estimators[path].is_silent(now) ||
           log_.count_under_way(peer.index, path, bulk_packets) < most;
  });
}

std::size_t LinkPacer::packets_allowed(TrafficClass traffic_class, Time now) const {
  const bool silent = peers_.is_silent(now);
  const bool probe_due = sent_at_ == Time::min() || now - sent_at_ >= seconds(repair_max_s);
  if ((silent && probe_due) || bulk_may_go(now)) return any_number;
  if (policy_of(traffic_class).passes_backlog) return bulk_packets;
  return silent || peers_.backlog(now) > seconds(params_.hold_backlog_s) ? 0 : bulk_packets;
}

Time LinkPacer::opens(Time now) const {
  if (peers_.is_silent(now)) return sent_at_ + seconds(repair_max_s);
  const Duration full = peers_.backlog(now);
  const Duration hold = seconds(params_.hold_backlog_s);
  return now + full - (full > hold ? hold : seconds(params_.bulk_backlog_s));
}

Time LinkPacer::repairs_open(Time now) const {
  if (!peers_.is_silent(now)) return now;
  return std::max(now, sent_at_ + seconds(params_.repair_first_s));
}

bool LinkPacer::is_idle(Time now) const {
  if (peers_.empty()) return false;
  if (peers_.is_silent(now)) return now - sent_at_ >= seconds(repair_max_s);
  return bulk_may_go(now) && peers_.backlog(now) == Duration::zero();
}

Time LinkPacer::idle_from(Time now) const {
  if (peers_.empty()) return never;
  if (peers_.is_silent(now)) return sent_at_ + seconds(repair_max_s);
  const Time drained = now + peers_.backlog(now);
  return drained > now ? drained : never;
}

}  // namespace tocsin::router
