// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/host_graph.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <map>
#include <mutex>
#include <thread>
#include <tuple>
#include <utility>

#include "fast_dds/graph_writer.hpp"
#include "fast_dds/service_ends.hpp"
#include "graph/ros_graph.hpp"
#include "idl_support/raw_type.hpp"
#include "link/flow_ends.hpp"
#include "rtps/this_host.hpp"
#include "runtime/middleware/link_bus.hpp"

namespace tocsin {
namespace {

constexpr int writer_depth = 10;
/// Whose nodes may wait at once until a thread of Fast DDS has taken them.
constexpr int most_participants = 256;

QosProfile profile_of(const RawTopic& topic) {
  QosProfile profile;
  profile.reliability = topic.reliable ? Reliability::reliable : Reliability::best_effort;
  profile.durability =
      topic.transient_local ? Durability::transient_local : Durability::volatile_kind;
  profile.depth = topic.transient_local ? 1 : writer_depth;
  return profile;
}

class Reading final : public RawReading {
 public:
  Reading(FastDdsParticipant& participant, const RawTopic& topic, FlowReader::OnSample on_sample)
      : reader_(participant, {topic.name, topic.type, topic.reliable, topic.transient_local},
                std::move(on_sample)) {}

 private:
  FlowReader reader_;
};

class Writing final : public RawWriting {
 public:
  Writing(FastDdsParticipant& participant, const RawTopic& topic, const QosProfile& profile)
      : profile_(profile),
        writer_(participant, topic.name, topic.type, profile_,
                [this, &participant](const auto& reader, bool there) {
                  if (there && reader != participant.prefix()) ++readers_;
                }) {}

  bool write(const std::vector<std::uint8_t>& bytes) override {
    CarriedSample sample;
    sample.content = std::make_shared<EncodedMessage>(EncodedMessage{bytes});
    sample.bytes = static_cast<std::uint32_t>(bytes.size());
    sample.source = source_;
    sample.sequence = ++sequence_;
    sample.sent_wall_ns = wall_now_ns();
    return writer_.write(sample).has_value();
  }
  [[nodiscard]] int readers() const override { return readers_; }

 private:
  std::atomic<int> readers_{0};  // before the writer, whose discovery counts
  const QosProfile profile_;
  FlowWriter writer_;
  const std::uint64_t source_ = fresh_source();
  std::uint64_t sequence_ = 0;
};

RawSample sample_of(TakenSample&& taken) {
  const auto encoded = std::static_pointer_cast<const EncodedMessage>(taken.sample.content);
  RawSample sample;
  sample.bytes = {encoded, &encoded->bytes};
  sample.source = taken.sample.source;
  sample.sequence = taken.sample.sequence;
  sample.sent_wall_ns = taken.sample.sent_wall_ns;
  sample.received = std::chrono::steady_clock::now();
  sample.received_wall_ns = wall_now_ns();
  return sample;
}

/// What participants tell of their nodes. Thread-safe.
class HeardNodes {
 public:
  void take(const std::vector<std::uint8_t>& bytes) {
    auto nodes = decode_nodes(bytes);
    if (!nodes) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    heard_[prefix_of(nodes->participant)] = std::move(nodes->nodes);
  }
  void forget(const RemoteEnds::Participant& participant) {
    RemoteEnds::Guid guid;
    guid.guidPrefix = participant;
    const std::lock_guard<std::mutex> lock(mutex_);
    heard_.erase(prefix_of(gid_of(guid)));
  }
  [[nodiscard]] std::vector<GraphNode> all() const {
    std::vector<GraphNode> all;
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      for (const auto& one : heard_) all.insert(all.end(), one.second.begin(), one.second.end());
    }
    std::sort(all.begin(), all.end(),
              [](const auto& one, const auto& other) { return one.path() < other.path(); });
    return all;
  }

 private:
  using Prefix = std::array<std::uint8_t, 12>;
  static Prefix prefix_of(const Gid& gid) {
    Prefix prefix;
    std::copy_n(gid.begin(), prefix.size(), prefix.begin());
    return prefix;
  }
  mutable std::mutex mutex_;
  std::map<Prefix, std::vector<GraphNode>> heard_;
};

ParticipantOptions participant_of(const BusOptions& options, HeardNodes& nodes) {
  ParticipantOptions made;
  made.name = options.name;
  made.domain = options.host_domain;
  made.on_participant = [&nodes](const auto& participant, const std::string&, bool there) {
    if (!there) nodes.forget(participant);
  };
  return made;
}

class FastDdsHostGraph final : public HostGraph {
 public:
  explicit FastDdsHostGraph(const BusOptions& options)
      : participant_(participant_of(options, nodes_)),
        discovery_(participant_,
                   {discovery_topic, discovery_type, discovery_qos(most_participants)},
                   [this](const auto& bytes, const auto&) { nodes_.take(*bytes); }) {}

  [[nodiscard]] std::vector<GraphEnd> ends() const override;
  [[nodiscard]] std::vector<GraphNode> nodes() const override { return nodes_.all(); }
  [[nodiscard]] std::unique_ptr<RawReading> read(
      const RawTopic& topic, std::function<void(RawSample&&)> on_sample) override {
    return std::make_unique<Reading>(participant_, topic,
                                     [on_sample = std::move(on_sample)](TakenSample&& taken) {
                                       on_sample(sample_of(std::move(taken)));
                                     });
  }
  [[nodiscard]] std::unique_ptr<ClientEnd> call(const ServiceEndpoint& endpoint,
                                                ClientReceiver& receiver) override {
    return std::make_unique<DdsClient>(participant_, "", endpoint, receiver);
  }
  [[nodiscard]] std::unique_ptr<RawWriting> write(const RawTopic& topic) override {
    return write(topic, profile_of(topic));
  }
  [[nodiscard]] std::unique_ptr<RawWriting> write(const RawTopic& topic,
                                                  const QosProfile& qos) override {
    return std::make_unique<Writing>(participant_, topic, qos);
  }

 private:
  HeardNodes nodes_;  // before the participant, which tells it who leaves
  FastDdsParticipant participant_;
  RawReader discovery_;
};

std::vector<GraphEnd> FastDdsHostGraph::ends() const {
  std::vector<GraphEnd> all;
  for (const RemoteEnds::Known& known : participant_.remote_ends().all()) {
    if (participant_.owns(known.guid)) continue;
    const AnnouncedEnd& end = known.end;
    all.push_back({end.topic, end.type, known.participant, gid_of(known.guid), end.writer, end.qos,
                   end.lifespan_s, end.user_data});
  }
  std::sort(all.begin(), all.end(), [](const GraphEnd& one, const GraphEnd& other) {
    return std::tie(one.topic, one.type, one.gid) < std::tie(other.topic, other.type, other.gid);
  });
  return all;
}

}  // namespace

std::vector<GraphEnd> settled_ends(const HostGraph& graph, Duration patience,
                                   const std::function<bool()>& is_over) {
  constexpr Duration look = std::chrono::milliseconds(50);
  constexpr Duration quiet = std::chrono::milliseconds(400);
  std::size_t before = 0;
  Duration unchanged{0};
  for (Duration waited{0}; waited < patience && unchanged < quiet && !(is_over && is_over());
       waited += look) {
    std::this_thread::sleep_for(look);
    const std::size_t now = graph.ends().size() + graph.nodes().size();
    unchanged = now == before && now > 0 ? unchanged + look : Duration{0};
    before = now;
  }
  return graph.ends();
}

RawTopic readable(const std::vector<const GraphEnd*>& writers) {
  const auto all = [&](auto offers) { return std::all_of(writers.begin(), writers.end(), offers); };
  RawTopic topic;
  topic.name = writers.front()->topic;
  topic.type = writers.front()->type;
  topic.reliable = all([](const auto* end) { return end->qos.reliable(); });
  topic.transient_local = topic.reliable && all([](const auto* end) {
                            return end->qos.durability != Durability::volatile_kind;
                          });
  return topic;
}

std::unique_ptr<HostGraph> make_host_graph(const BusOptions& options) {
  return std::make_unique<FastDdsHostGraph>(options);
}

}  // namespace tocsin
