// SPDX-License-Identifier: Apache-2.0
#include "link/flow_table.hpp"

#include <algorithm>
#include <utility>

#include "foundation/hash.hpp"
#include "link/flow_text.hpp"
#include "rtps/origin.hpp"
#include "runtime/middleware/link_permissions.hpp"
#include "runtime/middleware/refused_names.hpp"

namespace tocsin {
namespace {

/// Events that wait for a component that does not look; beyond them samples are lost.
constexpr std::size_t most_events = 4096;

bool is_sample(const LinkEvent& event) {
  return std::holds_alternative<link_event::HostSample>(event) ||
         std::holds_alternative<link_event::LinkSample>(event);
}

}  // namespace

FlowTable::FlowTable(const std::string& ros_namespace, const TrafficRules& rules,
                     std::function<void()> on_event)
    : names_(ros_namespace), rules_(rules), on_event_(std::move(on_event)) {}

std::optional<Flow> FlowTable::flow_in(const AnnouncedEnd& end, bool on_link) const {
  const auto topic = on_link ? link_names().of_people(end.topic) : names_.of_people(end.topic);
  if (!end.writer || !topic) return std::nullopt;
  if (!on_link && rules_.find(*topic) == nullptr) return std::nullopt;
  if (on_link && !rules_.takes(*topic) && !is_of_routers(rules_, *topic)) return std::nullopt;
  Flow flow;
  flow.topic = *topic;
  flow.type = end.type;
  flow.user_data = end.user_data;
  flow.lifespan_s = end.lifespan_s;
  flow.reliable = end.qos.reliable();
  flow.transient_local = end.qos.keeps_last();
  if (on_link) read_announcement(flow);
  return flow;
}

std::string FlowTable::name_of(const Participant& participant) const {
  const auto found = peers_.find(participant);
  return found == peers_.end() ? "" : found->second;
}

bool FlowTable::has_room(const Guid& guid, bool on_link) {
  const bool link_is_full = on_link && flows_.size() - host_flows_ >= most_link_flows;
  std::size_t* const own = on_link ? &link_flows_[guid.guidPrefix] : &host_flows_;
  if (*own < most_flows && !link_is_full) return ++*own > 0;
  if (*own == 0) link_flows_.erase(guid.guidPrefix);
  if (!std::exchange(told_full_, true)) {
    log_.warn("more than {} flows {}; what comes beyond them does not cross", most_flows,
              on_link ? "of " + name_of(guid.guidPrefix) : "of this host");
  }
  return false;
}

void FlowTable::add(const Guid& guid, const Flow& flow, bool on_link) {
  if (by_writer_.count(guid) != 0) return;  // announced again
  const auto found = std::find_if(flows_.begin(), flows_.end(), [&](const auto& entry) {
    return !on_link && !entry.second.on_link && entry.second.flow == flow;
  });
  if (found == flows_.end() && !has_room(guid, on_link)) return;
  const FlowId id = found == flows_.end() ? ++last_id_ : found->first;
  by_writer_[guid] = id;
  flows_[id].writers.insert(guid);
  if (found != flows_.end()) return;
  flows_[id].flow = flow;
  flows_[id].on_link = on_link;
  if (on_link) {
    events_.push_back(
        link_event::PeerFlow{id, peer_of(guid.guidPrefix), wire_id_of(guid.entityId), flow});
  } else {
    events_.push_back(link_event::HostFlow{id, flow});
  }
}

void FlowTable::remove(const Guid& guid) {
  const auto found = by_writer_.find(guid);
  if (found == by_writer_.end()) return;
  const FlowId id = found->second;
  by_writer_.erase(found);
  Known& known = flows_[id];
  known.writers.erase(guid);
  if (!known.writers.empty()) return;
  if (known.on_link) {
    const auto count = link_flows_.find(guid.guidPrefix);
    if (--count->second == 0) link_flows_.erase(count);
    events_.push_back(link_event::PeerFlowGone{id});
  } else {
    --host_flows_;
    events_.push_back(link_event::HostFlowGone{id});
  }
  flows_.erase(id);
}

std::vector<FlowTable::Guid> FlowTable::writers_of(PeerId peer) const {
  std::vector<Guid> writers;
  for (const auto& [guid, id] : by_writer_) {
    if (flows_.at(id).on_link && peer_of(guid.guidPrefix) == peer) writers.push_back(guid);
  }
  return writers;
}

/// Nothing for one that has departed: it has no name any more.
void FlowTable::note_superseded(PeerId peer) {
  if (instances_.name_of(peer).empty()) return;
  for (const auto& known : peers_) {
    if (peer_of(known.first) == peer) superseded_.push_back(known.first);
  }
}

std::vector<FlowTable::Participant> FlowTable::take_superseded() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(superseded_, {});
}

void FlowTable::apply(const PeerInstances::Change& change) {
  if (change.joined) {
    events_.push_back(link_event::PeerFound{*change.joined, instances_.name_of(*change.joined)});
  }
  if (change.left) {
    leave(*change.left);
    note_superseded(*change.left);
  }
  if (change.joined) join(*change.joined);
}

/// It may return, so that its writers are known all the same; of one that has departed they are
/// not.
void FlowTable::leave(PeerId peer) {
  std::map<Guid, Flow> goes_on;
  for (const Guid& guid : writers_of(peer)) {
    goes_on.emplace(guid, flows_.at(by_writer_.at(guid)).flow);
    remove(guid);
  }
  events_.push_back(link_event::PeerLost{peer});
  if (instances_.name_of(peer).empty()) return;
  for (const auto& [guid, flow] : goes_on) add(guid, flow, true);
}

void FlowTable::join(PeerId peer) {
  for (const Guid& guid : writers_of(peer)) {
    const FlowId id = by_writer_.at(guid);
    events_.push_back(
        link_event::PeerFlow{id, peer, wire_id_of(guid.entityId), flows_.at(id).flow});
  }
  for (const FlowId flow : listens_[peer]) {
    events_.push_back(link_event::PeerReaderMatched{flow, peer});
  }
}

void FlowTable::set_absent(const std::set<std::string>& hosts) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const PeerInstances::Change& change : instances_.set_absent(hosts)) {
      if (change.left) leave(*change.left);
      if (!change.joined) continue;
      events_.push_back(link_event::PeerFound{*change.joined, instances_.name_of(*change.joined)});
      join(*change.joined);
    }
  }
  on_event_();
}

void FlowTable::on_host_end(const Guid& guid, const AnnouncedEnd& end, bool there) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto flow = flow_in(end, false);
    if (!flow) return;
    there ? add(guid, *flow, false) : remove(guid);
  }
  on_event_();
}

void FlowTable::on_link_end(const Guid& guid, const AnnouncedEnd& end, bool there) {
  const auto topic = link_names().of_people(end.topic);
  if (!end.writer || !topic) return;
  std::optional<std::string> refused;  // of this peer
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto flow = flow_in(end, true);
    if (!flow && there) refused = name_of(guid.guidPrefix);
    if (flow) there ? add(guid, *flow, true) : remove(guid);
  }
  if (refused) return refuse("topic", *topic, *refused, log_);
  on_event_();
}

void FlowTable::on_peer(const Participant& participant, const std::string& name, bool there,
                        Time now) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const PeerId peer = peer_of(participant);
    if (there) {
      peers_.try_emplace(participant, name);
      apply(instances_.on_announced(peer, name, now));
    } else {
      apply(instances_.on_departed(peer, now));
      for (const Guid& guid : writers_of(peer)) remove(guid);
      peers_.erase(participant);
      listens_.erase(peer);
    }
  }
  on_event_();
}

void FlowTable::on_peer_listens(const Participant& participant, FlowId flow, bool there) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const PeerId peer = peer_of(participant);
    if (there) {
      listens_[peer].insert(flow);
      events_.push_back(link_event::PeerReaderMatched{flow, peer});
    } else {
      listens_[peer].erase(flow);
      events_.push_back(link_event::PeerReaderGone{flow, peer});
    }
  }
  on_event_();
}

bool FlowTable::on_received(const Guid& writer, Time now) {
  const PeerId peer = peer_of(writer.guidPrefix);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto change = instances_.on_received(peer, now);
    if (!change.joined) return instances_.counts(peer);
    apply(change);
  }
  on_event_();
  return true;
}

void FlowTable::push(LinkEvent event) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (events_.size() >= most_events && is_sample(event)) return;
    events_.push_back(std::move(event));
  }
  on_event_();
}

std::optional<LinkEvent> FlowTable::pop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (events_.empty()) return std::nullopt;
  LinkEvent event = std::move(events_.front());
  events_.pop_front();
  return event;
}

FlowId FlowTable::fresh_id() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return ++last_id_;
}

std::optional<FlowId> FlowTable::flow_of(const Guid& writer) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = by_writer_.find(writer);
  return found == by_writer_.end() ? std::nullopt : std::optional(found->second);
}

std::optional<FlowId> FlowTable::flow_of(const Guid& writer, bool reliable,
                                         bool transient_local) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = by_writer_.find(writer);
  if (found == by_writer_.end()) return std::nullopt;
  const Flow& flow = flows_.at(found->second).flow;
  const bool offers_that = flow.reliable == reliable && flow.transient_local == transient_local;
  return offers_that ? std::optional(found->second) : std::nullopt;
}

std::optional<Flow> FlowTable::find(FlowId id) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = flows_.find(id);
  return found == flows_.end() ? std::nullopt : std::optional(found->second.flow);
}

PeerId FlowTable::peer_of(const Participant& participant) {
  return hash_of(std::string(participant.value, participant.value + Participant::size));
}

}  // namespace tocsin
