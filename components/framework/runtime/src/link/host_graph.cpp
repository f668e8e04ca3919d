// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/host_graph.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <sstream>
#include <thread>
#include <tuple>
#include <utility>

#include "fast_dds/this_host.hpp"
#include "link/flow_ends.hpp"
#include "link/raw_type.hpp"

namespace tocsin {
namespace {

constexpr int writer_depth = 10;

std::string text_of(const RemoteEnds::Guid& guid) {
  std::ostringstream text;
  text << guid;
  return text.str();
}

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
                [this, &participant](const auto& reader) {
                  if (reader != participant.prefix()) ++readers_;
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

ParticipantOptions participant_of(const BusOptions& options) {
  ParticipantOptions made;
  made.name = options.name;
  made.domain = options.host_domain;
  return made;
}

class FastDdsHostGraph final : public HostGraph {
 public:
  explicit FastDdsHostGraph(const BusOptions& options) : participant_(participant_of(options)) {}

  [[nodiscard]] std::vector<GraphEnd> ends() const override;
  [[nodiscard]] std::unique_ptr<RawReading> read(
      const RawTopic& topic, std::function<void(RawSample&&)> on_sample) override {
    return std::make_unique<Reading>(participant_, topic,
                                     [on_sample = std::move(on_sample)](TakenSample&& taken) {
                                       on_sample(sample_of(std::move(taken)));
                                     });
  }
  [[nodiscard]] std::unique_ptr<RawWriting> write(const RawTopic& topic) override {
    return write(topic, profile_of(topic));
  }
  [[nodiscard]] std::unique_ptr<RawWriting> write(const RawTopic& topic,
                                                  const QosProfile& qos) override {
    return std::make_unique<Writing>(participant_, topic, qos);
  }

 private:
  FastDdsParticipant participant_;
};

std::vector<GraphEnd> FastDdsHostGraph::ends() const {
  std::vector<GraphEnd> all;
  for (const RemoteEnds::Known& known : participant_.remote_ends().all()) {
    if (participant_.owns(known.guid)) continue;
    const AnnouncedEnd& end = known.end;
    all.push_back({end.topic, end.type, known.participant, text_of(known.guid), end.writer, end.qos,
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
    const std::size_t now = graph.ends().size();
    unchanged = now == before && now > 0 ? unchanged + look : Duration{0};
    before = now;
  }
  return graph.ends();
}

std::unique_ptr<HostGraph> make_host_graph(const BusOptions& options) {
  return std::make_unique<FastDdsHostGraph>(options);
}

}  // namespace tocsin
