// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "foundation/link_path.hpp"
#include "foundation/sample_coding.hpp"
#include "foundation/sample_piece.hpp"
#include "foundation/stop_value.hpp"
#include "foundation/time.hpp"
#include "foundation/traffic_class.hpp"
#include "idl_support/type_info.hpp"
#include "runtime/middleware/host_services.hpp"
#include "runtime/middleware/traffic_rules.hpp"

namespace tocsin {

/// What the writers of a topic announce, without their C++ type. All writers of a host that
/// announce the same are one flow, and cross the link as one writer.
struct Flow {
  std::string topic;             ///< ROS name without leading slash and namespace
  std::string type;              ///< wire name: `std_msgs::msg::dds_::Bool_`
  bool reliable = false;         ///< what they offer to readers on their host
  bool transient_local = false;  ///< a late reader gets the last samples
  int depth = 1;                 ///< [1, 10000] samples that count; 1: only the newest
  double lifespan_s = std::numeric_limits<double>::infinity();  ///< older ones are not delivered
  std::string user_data;  ///< announced with them, such as the layout of the type
  bool stored = false;    ///< on the link: what does not cross at first is backfilled later
  PathIndex path = 0;     ///< on the link: by which the packets of this writer go
};
[[nodiscard]] inline bool operator==(const Flow& one, const Flow& other) {
  const auto all = [](const Flow& flow) {
    return std::tie(flow.topic, flow.type, flow.reliable, flow.transient_local, flow.depth,
                    flow.lifespan_s, flow.user_data, flow.stored, flow.path);
  };
  return all(one) == all(other);
}
[[nodiscard]] inline bool operator!=(const Flow& one, const Flow& other) { return !(one == other); }

/// A sample on its way between the host and the link, of any type.
struct CarriedSample {
  std::shared_ptr<const void> content;  ///< encoded; in a simulation the message itself
  std::uint32_t bytes = 0;              ///< serialised, encapsulation header included
  std::uint64_t source = 0;             ///< who wrote it, as in Sample, on whatever host
  std::uint64_t sequence = 0;           ///< of that writer
  std::int64_t sent_wall_ns = 0;        ///< [ns] since the Unix epoch, that writer's clock
  SampleCoding coding{};                ///< of the content
};
/// Of a sample that is compressed by `base` (null: by itself); nothing where it is too far before.
[[nodiscard]] inline std::optional<SampleCoding> coding_of(const CarriedSample& sample,
                                                           const CarriedSample* base) {
  return compressed_by(sample.sequence,
                       base != nullptr ? std::optional(base->sequence) : std::nullopt);
}

/// Given by the bus; never used again.
using FlowId = std::uint32_t;
/// One life of a peer's router.
using PeerId = std::uint64_t;

/// What happens at a LinkBus.
namespace link_event {
struct HostFlow {  ///< somebody on this host begins to write
  FlowId flow;
  Flow what;
};
struct HostFlowGone {
  FlowId flow;
};
struct HostSample {
  FlowId flow;
  CarriedSample sample;
  Time received{};
};
struct PeerFound {
  PeerId peer;
  std::string name;  ///< of its host
};
struct PeerLost {
  PeerId peer;
};
/// A peer's router begins to write on the link. What it sends by the second path is a flow of its
/// own, which differs from the one of the first in Flow::path alone.
struct PeerFlow {
  FlowId flow;
  PeerId peer;
  std::uint32_t wire_id;  ///< by which both sides know it, see LinkBus::wire_id
  Flow what;
};
struct PeerFlowGone {
  FlowId flow;
};
struct PeerReaderMatched {  ///< a peer's router has begun to read what is sent on a flow of `open`
  FlowId flow;
  PeerId peer;
};
struct PeerReaderGone {  ///< of a topic on demand: nobody on that peer's host reads it any more
  FlowId flow;
  PeerId peer;
};
struct HostReaderMatched {  ///< a reader of this host hears a flow of `offer`
  FlowId flow;
};
struct LinkSample {
  FlowId flow;           ///< of the peer
  std::uint64_t number;  ///< of this transmission within the flow, from 1 without gaps
  CarriedSample sample;  ///< of a piece, what LinkBus::join takes
  Time received{};
  SamplePiece piece{};
  PathIndex path = 0;  ///< that it came by
};
}  // namespace link_event
using LinkEvent =
    std::variant<link_event::HostFlow, link_event::HostFlowGone, link_event::HostSample,
                 link_event::PeerFound, link_event::PeerLost, link_event::PeerFlow,
                 link_event::PeerFlowGone, link_event::PeerReaderMatched,
                 link_event::PeerReaderGone, link_event::HostReaderMatched, link_event::LinkSample>;

/// What a flow on the link is for.
enum class LinkPurpose {
  samples,           ///< of topics, services and actions
  acknowledgements,  ///< between routers
  backfill,          ///< samples that did not cross at first
};

/// IP packets that a host's router has put on the link since its start, by what is in them.
struct LinkPackets {
  std::uint64_t packets = 0;
  std::uint64_t bytes = 0;              ///< with IP and UDP headers
  std::uint64_t discovery_packets = 0;  ///< of participants and endpoints
  std::uint64_t discovery_bytes = 0;
  std::uint64_t acknowledgement_bytes = 0;  ///< between routers
  std::uint64_t backfill_bytes = 0;         ///< of samples that did not cross at first
  std::uint64_t stop_bytes = 0;  ///< of the emergency stop's value, in packets and between
  /// Of bytes: those of the flows of each class, acknowledgements and backfill included.
  std::array<std::uint64_t, traffic_classes.size()> class_bytes{};
  std::uint64_t second_bytes = 0;  ///< of bytes: by the second path

  /// A packet of a flow of `open`.
  void add(TrafficClass traffic_class, LinkPurpose purpose, std::uint64_t size) {
    ++packets;
    bytes += size;
    class_bytes[static_cast<std::size_t>(traffic_class)] += size;
    if (purpose == LinkPurpose::acknowledgements) acknowledgement_bytes += size;
    if (purpose == LinkPurpose::backfill) backfill_bytes += size;
  }
  void add_discovery(std::uint64_t size) {
    ++packets;
    bytes += size;
    ++discovery_packets;
    discovery_bytes += size;
  }
  /// Of the emergency stop's value: in a packet that is counted, or in one of its own.
  void add_stop(std::uint64_t size, bool is_packet) {
    packets += is_packet ? 1 : 0;
    bytes += size;
    stop_bytes += size;
  }
};

/// What the one process that owns the radio of a host needs of the middleware: topics of any type
/// between the host's domain and the link's. Nothing repairs a loss on the link: each transmission
/// has a number, and whoever wants it repaired sends it again.
///
/// One thread calls everything. Its maker is told, from any thread, when `take` has something.
class LinkBus {
 public:
  virtual ~LinkBus() = default;

  /// The oldest thing that happened and was not taken yet.
  [[nodiscard]] virtual std::optional<LinkEvent> take() = 0;
  /// This router's own life, as its peers see it; zero while the link is not up.
  [[nodiscard]] virtual PeerId self() const = 0;
  /// Whether samples of a HostFlow are taken from the host. Only of topics that wait for demand
  /// (TrafficRules), which begin as not wanted: when they become so, the last samples of states
  /// come. The same again changes nothing.
  virtual void want(FlowId /*host_flow*/, bool /*wanted*/) {}
  /// By which name the peers know this router.
  [[nodiscard]] virtual std::string host() const { return ""; }
  /// Of a vehicle with several sites: the names of their hosts, the preferred one first.
  [[nodiscard]] virtual std::vector<std::string> sites() const { return {}; }
  /// Peers of these hosts are lost from now on, although they are received: they get discovery and
  /// the emergency stop alone. Another set replaces it; who is in it no more is found at once.
  virtual void set_absent(const std::set<std::string>& /*hosts*/) {}
  /// [1, most_paths] Paths over the link.
  [[nodiscard]] virtual PathIndex paths() const { return 1; }
  /// Makes a writer on each path of the link, whose packets bear the DSCP of the class.
  virtual FlowId open(const Flow& flow, TrafficClass traffic_class) = 0;
  /// The number by which the peers know a flow of `open` on a path: the entity id of its writer.
  /// Zero while the link is not up, and where there is no such path.
  [[nodiscard]] virtual std::uint32_t wire_id(FlowId flow, PathIndex path) const = 0;
  /// Nothing of it is sent any more.
  virtual void close(FlowId flow) = 0;
  /// One transmission on a flow of `open`, of a piece of the sample. Returns its number, the next
  /// of the flow on that path; nothing when the middleware refused it, or the link is not up.
  [[nodiscard]] virtual std::optional<std::uint64_t> send(FlowId flow, const CarriedSample& sample,
                                                          SamplePiece piece, PathIndex path) = 0;
  /// [B] of a sample that cross in one packet; 0 while somebody reads who does not join pieces.
  [[nodiscard]] virtual std::size_t largest_piece() const = 0;
  /// The sample whose pieces were received, all of them in their order. `last`: any of them.
  [[nodiscard]] virtual CarriedSample join(
      const CarriedSample& last, const std::vector<std::shared_ptr<const void>>& pieces) const = 0;
  /// A sample in fewer bytes, for routers that have `base` (null: nothing); its coding says how.
  /// Nothing when `base` is too far before it, or nothing is compressed here.
  [[nodiscard]] virtual std::optional<CarriedSample> compress(const CarriedSample& /*sample*/,
                                                              const CarriedSample* /*base*/) {
    return std::nullopt;
  }
  /// The sample that was compressed so; nothing when these are no such bytes, or `base` is not the
  /// one that it was compressed by.
  [[nodiscard]] virtual std::optional<CarriedSample> restore(const CarriedSample& /*compressed*/,
                                                             const CarriedSample* /*base*/) {
    return std::nullopt;
  }
  /// Makes the writer on this host of a peer's flow. A HostReaderMatched reports each reader of
  /// another process that it matches from then on. A topic that the rules take on demand is
  /// received while it has such a reader.
  virtual void offer(FlowId peer_flow) = 0;
  /// The same of a flow that is no peer's, under a number for `deliver`.
  virtual FlowId offer(const Flow& flow) = 0;
  /// Writes there, as from the sample's own writer.
  virtual void deliver(FlowId flow, const CarriedSample& sample) = 0;

  /// What a log keeps of a sample, and back. In a simulation only for its own world.
  [[nodiscard]] virtual std::vector<std::uint8_t> bytes_of(const CarriedSample& sample) const = 0;
  /// The content and its size; null when these are no such bytes.
  [[nodiscard]] virtual CarriedSample sample_of(std::vector<std::uint8_t> bytes) const = 0;

  /// A message of a type that is known here, and back. Null when it is no such message.
  [[nodiscard]] virtual CarriedSample pack(const TypeInfo& type,
                                           std::shared_ptr<const void> message) const = 0;
  [[nodiscard]] virtual std::shared_ptr<const void> unpack(const TypeInfo& type,
                                                           const CarriedSample& sample) const = 0;
  /// The gate of this router has opened or closed: what a simulation tells those who watch.
  virtual void on_gate(bool /*open*/) {}
  /// The services of this host; null where none cross: in a simulation, or by the rules.
  [[nodiscard]] virtual HostServices* services() { return nullptr; }
  /// What every packet to the peers says of the emergency stop from now on. It is not sent for
  /// longer than stop_value_lives unless it is said again. The bus adds the name of its host.
  virtual void say_stop(const StopValue& value) = 0;
  /// What packets of the peers said since the last call. The maker is told of what is new.
  [[nodiscard]] virtual StopNews take_stop_news() = 0;
  /// The topics of this host that cross, and how.
  [[nodiscard]] virtual const TrafficRules& rules() const = 0;
  [[nodiscard]] virtual LinkPackets packets() const = 0;
};

/// What a bus has whose process is the router of its host.
class LinkAccess {
 public:
  virtual ~LinkAccess() = default;
  /// Once at a time. `on_event` is called, by any thread, when LinkBus::take has something.
  [[nodiscard]] virtual std::unique_ptr<LinkBus> open_link(
      const std::function<void()>& on_event) = 0;
};

}  // namespace tocsin
