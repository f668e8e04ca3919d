// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "fast_dds/remote_ends.hpp"
#include "link/peer_instances.hpp"
#include "qos/topic_names.hpp"
#include "runtime/fast_dds/names.hpp"
#include "runtime/logger.hpp"
#include "runtime/middleware/link_bus.hpp"

namespace tocsin {

/// Which flows there are on a host and on the link, from what discovery tells, and what has
/// happened to them. Of the link it takes what the rules say, of a host and of each peer at most
/// `most_flows`; what it does not take of the link is counted, see refuse(). Any thread; `on_event`
/// is called without a lock held.
class FlowTable {
 public:
  using Guid = eprosima::fastdds::rtps::GUID_t;
  using Participant = eprosima::fastdds::rtps::GuidPrefix_t;
  /// Many more than a robot has topics.
  static constexpr std::size_t most_flows = 1024;
  /// Of all peers.
  static constexpr std::size_t most_link_flows = 4096;

  FlowTable(const std::string& ros_namespace, const TrafficRules& rules,
            std::function<void()> on_event);

  /// Somebody on the host has begun or ended to write.
  void on_host_end(const Guid& guid, const AnnouncedEnd& end, bool there);
  /// The same on the link.
  void on_link_end(const Guid& guid, const AnnouncedEnd& end, bool there);
  /// Of the instances of a peer one counts: see PeerInstances. A flow of another one is reported
  /// without its peer, so that its samples are received, and again when it counts.
  void on_peer(const Participant& participant, const std::string& name, bool there, Time now);
  /// Peers of these hosts are reported as lost, and what is received of them is not taken, until
  /// another set replaces it.
  void set_absent(const std::set<std::string>& hosts);
  /// A peer has begun, or ended, to read what is sent on a flow of ours.
  void on_peer_listens(const Participant& participant, FlowId flow, bool there);
  /// A sample of a writer on the link was received. Whether its instance of the peer counts.
  [[nodiscard]] bool on_received(const Guid& writer, Time now);
  /// Samples that come when 4096 events wait are lost.
  void push(LinkEvent event);
  [[nodiscard]] std::optional<LinkEvent> pop();
  void wake() const { on_event_(); }

  /// Participants whose place another instance of their peer has taken since.
  [[nodiscard]] std::vector<Participant> take_superseded();

  [[nodiscard]] FlowId fresh_id();
  [[nodiscard]] std::optional<FlowId> flow_of(const Guid& writer) const;
  /// The same if that flow offers just this.
  [[nodiscard]] std::optional<FlowId> flow_of(const Guid& writer, bool reliable,
                                              bool transient_local) const;
  /// What is known of a flow of the host or of a peer.
  [[nodiscard]] std::optional<Flow> find(FlowId id) const;
  [[nodiscard]] static PeerId peer_of(const Participant& participant);
  /// Of the host's topics; those on the link have link_names().
  [[nodiscard]] const TopicNames& names() const { return names_; }

 private:
  struct Known {
    Flow flow;
    bool on_link = false;
    std::set<Guid> writers;
  };
  [[nodiscard]] std::optional<Flow> flow_in(const AnnouncedEnd& end, bool on_link) const;
  /// Whether there is room for one more flow of this writer's side.
  [[nodiscard]] bool has_room(const Guid& guid, bool on_link);
  [[nodiscard]] std::string name_of(const Participant& participant) const;
  void add(const Guid& guid, const Flow& flow, bool on_link);
  void remove(const Guid& guid);
  [[nodiscard]] std::vector<Guid> writers_of(PeerId peer) const;
  void note_superseded(PeerId peer);
  void apply(const PeerInstances::Change& change);
  void leave(PeerId peer);
  void join(PeerId peer);

  const TopicNames names_;
  const TrafficRules& rules_;
  const std::function<void()> on_event_;
  Logger log_{"link"};
  mutable std::mutex mutex_;
  std::size_t host_flows_ = 0;
  std::map<Participant, std::size_t> link_flows_;
  bool told_full_ = false;
  FlowId last_id_ = 0;
  std::map<FlowId, Known> flows_;
  std::map<Guid, FlowId> by_writer_;
  std::map<Participant, std::string> peers_;
  PeerInstances instances_;
  std::vector<Participant> superseded_;
  std::map<PeerId, std::set<FlowId>> listens_;  ///< to these of ours
  std::deque<LinkEvent> events_;
};

}  // namespace tocsin
