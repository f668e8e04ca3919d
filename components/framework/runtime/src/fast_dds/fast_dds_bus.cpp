// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/fast_dds_bus.hpp"

#include <atomic>
#include <chrono>
#include <limits>
#include <map>
#include <mutex>
#include <utility>

#include "fast_dds/graph_writer.hpp"
#include "fast_dds/this_host.hpp"
#include "fast_dds/topic_channel.hpp"
#include "foundation/error.hpp"
#include "runner/tick_time.hpp"

namespace tocsin {
namespace {

/// Wall time of an instant close to now, at the price of one clock reading in 10 ms. Any thread.
class WallClock {
 public:
  [[nodiscard]] std::int64_t at(Time now) {
    const std::int64_t ns = now.time_since_epoch().count();
    if (ns - read_ns_.load(std::memory_order_relaxed) > 10'000'000) {
      offset_ns_.store(wall_now_ns() - ns, std::memory_order_relaxed);
      read_ns_.store(ns, std::memory_order_relaxed);
    }
    return ns + offset_ns_.load(std::memory_order_relaxed);
  }

 private:
  std::atomic<std::int64_t> read_ns_{std::numeric_limits<std::int64_t>::min() / 2};
  std::atomic<std::int64_t> offset_ns_{0};
};

ParticipantOptions host_options(const BusOptions& options, const QosProfiles& profiles) {
  ParticipantOptions host;
  host.name = options.name;
  host.domain = options.host_domain;
  host.shared_memory = options.shared_memory;
  host.user_data = "enclave=/;";  // a participant of ROS 2
  host.flow_controllers = profiles.flow_controllers();
  return host;
}

class FastDdsBus : public Bus {
 public:
  explicit FastDdsBus(const BusOptions& options)
      : options_(options),
        profiles_(options.qos_file.empty() ? QosProfiles() : QosProfiles(options.qos_file)),
        rules_(options.traffic_file.empty() ? TrafficRules()
                                            : TrafficRules(options.traffic_file, options.role)),
        participant_(host_options(options, profiles_)),
        nodes_(options.ros_namespace),
        graph_(participant_, options.gid_size) {}

  std::unique_ptr<Subscription> subscribe(const Endpoint& endpoint, Receiver& receiver) override;
  std::unique_ptr<Publication> advertise(const Endpoint& endpoint) override;
  /// The publication with this source is gone.
  void withdraw(TopicChannel& topic, std::uint64_t source);
  [[nodiscard]] Time now() const override { return std::chrono::steady_clock::now(); }
  [[nodiscard]] std::int64_t wall_ns(Time t) const override;
  std::unique_ptr<LinkBus> open_link(const std::function<void()>& on_event) override {
    if (options_.link_address.empty()) return nullptr;
    return make_fast_dds_link_bus(options_, on_event);
  }
  int change_qos(const QosChange& change) override;
  void update_graph() override { graph_.tell(nodes_.all()); }
  [[nodiscard]] std::vector<EndpointHealth> health() const override;
  [[nodiscard]] LocalNodes& nodes() { return nodes_; }

 private:
  TopicChannel& channel(const Endpoint& endpoint);
  [[nodiscard]] std::unique_ptr<TopicChannel> make_channel(const Endpoint& endpoint);

  const BusOptions options_;
  const QosProfiles profiles_;
  const TrafficRules rules_;
  FastDdsParticipant participant_;
  LocalNodes nodes_;
  GraphWriter graph_;
  mutable std::mutex mutex_;
  std::map<std::string, std::unique_ptr<TopicChannel>> channels_;
};

/// An end that a node has as long as this lives.
class NodeEnd {
 public:
  NodeEnd(LocalNodes& nodes, std::string node, LocalNodes::End end, const Gid& gid)
      : nodes_(nodes), node_(std::move(node)), end_(end), gid_(gid) {
    nodes_.add(node_, end_, gid_);
  }
  ~NodeEnd() { nodes_.remove(node_, end_, gid_); }
  NodeEnd(const NodeEnd&) = delete;
  NodeEnd& operator=(const NodeEnd&) = delete;

 private:
  LocalNodes& nodes_;
  const std::string node_;
  const LocalNodes::End end_;
  const Gid gid_;
};

/// Removes the receiver when it is destroyed.
class ChannelSubscription : public Subscription {
 public:
  ChannelSubscription(FastDdsBus& bus, TopicChannel& channel, const std::string& node,
                      Receiver& receiver)
      : channel_(channel),
        receiver_(receiver),
        end_(bus.nodes(), node, LocalNodes::End::reader, channel_.attach(receiver_, bus.now())) {}
  ~ChannelSubscription() override { channel_.detach(receiver_); }
  [[nodiscard]] std::optional<WriterInfo> writer(std::uint64_t source) const override {
    return channel_.writer(source);
  }

 private:
  TopicChannel& channel_;
  Receiver& receiver_;
  const NodeEnd end_;
};

class ChannelPublication : public Publication {
 public:
  ChannelPublication(FastDdsBus& bus, TopicChannel& channel, const std::string& node,
                     std::uint64_t source, const Gid& writer)
      : bus_(bus),
        channel_(channel),
        source_(source),
        end_(bus.nodes(), node, LocalNodes::End::writer, writer) {}
  ~ChannelPublication() override { bus_.withdraw(channel_, source_); }

  Status write(const std::shared_ptr<const void>& message) override {
    Sample head;
    head.received = TickTime::now() != never ? TickTime::now() : bus_.now();
    head.sent_wall_ns = head.received_wall_ns = wall_.at(head.received);
    head.source = source_;
    return channel_.write(message, std::move(head), delivered_);
  }
  [[nodiscard]] bool has_readers() const override { return channel_.has_readers(); }

 private:
  FastDdsBus& bus_;
  TopicChannel& channel_;
  const std::uint64_t source_;
  const NodeEnd end_;
  std::uint64_t delivered_ = 0;  // guarded by the channel
  WallClock wall_;
};

std::unique_ptr<TopicChannel> FastDdsBus::make_channel(const Endpoint& endpoint) {
  const std::string name = endpoint.topic.name;
  const std::string prefix =
      options_.ros_namespace.empty() ? "rt/" : "rt/" + options_.ros_namespace + "/";
  return std::make_unique<TopicChannel>(
      ChannelOptions{endpoint, prefix + name, profiles_.of(endpoint.topic.qos, name)},
      participant_);
}

TopicChannel& FastDdsBus::channel(const Endpoint& endpoint) {
  const std::lock_guard<std::mutex> lock(mutex_);
  auto known = channels_.find(endpoint.topic.name);
  if (known == channels_.end()) {
    known = channels_.emplace(endpoint.topic.name, make_channel(endpoint)).first;
  }
  const auto& found = known->second;
  if (found->type() != endpoint.type) {
    throw ConfigError(std::string("topic ") + endpoint.topic.name + ": type " +
                      endpoint.type->name + " clashes with " + found->type()->name);
  }
  return *found;
}

std::unique_ptr<Subscription> FastDdsBus::subscribe(const Endpoint& endpoint, Receiver& receiver) {
  return std::make_unique<ChannelSubscription>(*this, channel(endpoint), endpoint.node, receiver);
}

std::unique_ptr<Publication> FastDdsBus::advertise(const Endpoint& endpoint) {
  TopicChannel& topic = channel(endpoint);
  if (endpoint.topic.scope == Scope::link) (void)rules_.of(endpoint.topic.name);
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::uint64_t source = fresh_source();
  const Gid writer = topic.advertise(source, endpoint.user_data);
  return std::make_unique<ChannelPublication>(*this, topic, endpoint.node, source, writer);
}

void FastDdsBus::withdraw(TopicChannel& topic, std::uint64_t source) {
  const std::lock_guard<std::mutex> lock(mutex_);  // the accounts look at its writer
  topic.withdraw(source);
}

int FastDdsBus::change_qos(const QosChange& change) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = channels_.find(change.topic);
  return found != channels_.end() ? found->second->change_qos(change, now()) : 0;
}

std::int64_t FastDdsBus::wall_ns(Time t) const { return wall_now_ns() - (now() - t).count(); }

std::vector<EndpointHealth> FastDdsBus::health() const {
  std::vector<EndpointHealth> all;
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& entry : channels_) {
    for (EndpointHealth& one : entry.second->health(now())) all.push_back(std::move(one));
  }
  return all;
}

}  // namespace

std::unique_ptr<Bus> make_fast_dds_bus(const BusOptions& options) {
  return std::make_unique<FastDdsBus>(options);
}

}  // namespace tocsin
