// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/fast_dds_bus.hpp"

#include <chrono>
#include <map>
#include <mutex>
#include <set>
#include <utility>

#include "fast_dds/graph_writer.hpp"
#include "fast_dds/node_ends.hpp"
#include "fast_dds/service_ends.hpp"
#include "fast_dds/topic_channel.hpp"
#include "foundation/error.hpp"
#include "foundation/ros_names.hpp"
#include "graph/ros_graph.hpp"
#include "rtps/this_host.hpp"
#include "runner/tick_time.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/host_graph.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "runtime/middleware/qos_change.hpp"

namespace tocsin {
namespace {

/// Calls who wants to know of callers. Thread-safe.
class CallerWatch {
 public:
  void set(std::function<void()> notice) {
    const std::lock_guard<std::mutex> lock(mutex_);
    notice_ = std::move(notice);
  }
  void notice() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (notice_) notice_();
  }

 private:
  std::mutex mutex_;
  std::function<void()> notice_;
};

ParticipantOptions host_options(const BusOptions& options, CallerWatch& watch) {
  ParticipantOptions host;
  host.name = options.name;
  host.domain = options.host_domain;
  host.farewell = std::chrono::milliseconds(300);
  host.user_data = participant_data_for(options.vehicle);
  host.on_end = [&watch](const auto&, const AnnouncedEnd& end, bool) {
    if (end.writer && ros_service(end.topic)) watch.notice();
  };
  host.on_participant = [&watch](const auto&, const auto&, bool) { watch.notice(); };
  return host;
}

class FastDdsBus final : public Bus, private HostControl, private LinkAccess {
 public:
  explicit FastDdsBus(const BusOptions& options)
      : options_(options),
        profiles_(options.qos_file.empty() ? QosProfiles() : QosProfiles(options.qos_file)),
        rules_(options.traffic_file.empty() ? TrafficRules()
                                            : TrafficRules(options.traffic_file, options.role)),
        participant_(host_options(options, watch_)),
        nodes_(options.ros_namespace),
        graph_(participant_, options.gid_size) {}

  std::unique_ptr<Subscription> subscribe(const Endpoint& endpoint, Receiver& receiver) override;
  std::unique_ptr<Publication> advertise(const Endpoint& endpoint) override;
  /// The publication with this source is gone.
  void withdraw(TopicChannel& topic, std::uint64_t source);
  [[nodiscard]] Time now() const override { return std::chrono::steady_clock::now(); }
  [[nodiscard]] std::int64_t wall_ns(Time t) const override;
  std::unique_ptr<ServerEnd> serve(const ServiceEndpoint& endpoint,
                                   ServerReceiver& receiver) override;
  std::unique_ptr<ClientEnd> call(const ServiceEndpoint& endpoint,
                                  ClientReceiver& receiver) override;
  [[nodiscard]] HostControl& host_control() override { return *this; }
  [[nodiscard]] LinkAccess* link_access() override {
    return options_.link_address.empty() ? nullptr : this;
  }
  [[nodiscard]] LocalNodes& nodes() { return nodes_; }

 private:
  [[nodiscard]] const std::string& ros_namespace() const override { return options_.ros_namespace; }
  [[nodiscard]] Callers callers() const override;
  void watch_callers(const std::function<void()>& notice) override { watch_.set(notice); }
  void update_graph() override { graph_.tell(nodes_.all()); }
  int change_qos(const QosChange& change) override;
  [[nodiscard]] std::vector<EndpointHealth> health() const override;
  [[nodiscard]] std::unique_ptr<HostGraph> open_graph() const override;
  std::unique_ptr<LinkBus> open_link(const std::function<void()>& on_event) override {
    BusOptions options = options_;
    options.ros_namespace = options_.routed_namespace.value_or(options_.ros_namespace);
    return make_fast_dds_link_bus(options, on_event);
  }
  TopicChannel& channel(const Endpoint& endpoint);
  [[nodiscard]] std::unique_ptr<TopicChannel> make_channel(const Endpoint& endpoint);

  const BusOptions options_;
  const QosProfiles profiles_;
  const TrafficRules rules_;
  CallerWatch watch_;  // before the participant, which tells it
  FastDdsParticipant participant_;
  LocalNodes nodes_;
  OwnCalls own_calls_;
  GraphWriter graph_;
  mutable std::mutex mutex_;
  std::map<std::string, std::unique_ptr<TopicChannel>> channels_;
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
    return channel_.write(message, head(), delivered_);
  }
  Status end_instance(const std::shared_ptr<const void>& message, InstanceState how) override {
    Sample end = head();
    end.state = how;
    return channel_.end_instance(message, std::move(end));
  }
  [[nodiscard]] bool has_readers() const override { return channel_.has_readers(); }
  [[nodiscard]] bool is_read() const override { return channel_.is_read(); }

 private:
  Sample head() {
    Sample head;
    head.received = TickTime::now() != never ? TickTime::now() : bus_.now();
    head.sent_wall_ns = head.received_wall_ns = bus_.wall_ns(head.received);
    head.source = source_;
    return head;
  }

  FastDdsBus& bus_;
  TopicChannel& channel_;
  const std::uint64_t source_;
  const NodeEnd end_;
  std::uint64_t delivered_ = 0;  // guarded by the channel
};

std::unique_ptr<TopicChannel> FastDdsBus::make_channel(const Endpoint& endpoint) {
  const std::string name = endpoint.topic.name;
  const bool absolute = name.front() == '/';
  const std::string prefix =
      absolute || options_.ros_namespace.empty() ? "" : options_.ros_namespace + "/";
  const std::string on_wire = "rt" + (absolute ? name : "/" + prefix + name);
  return std::make_unique<TopicChannel>(
      ChannelOptions{endpoint, options_.plain_names ? name : on_wire,
                     profiles_.of(endpoint.topic.qos, name)},
      participant_);
}

std::unique_ptr<ServerEnd> FastDdsBus::serve(const ServiceEndpoint& endpoint,
                                             ServerReceiver& receiver) {
  auto server =
      std::make_unique<DdsServer>(participant_, options_.ros_namespace, endpoint, receiver);
  return std::make_unique<NodeServer>(nodes_, endpoint.node, std::move(server));
}

std::unique_ptr<ClientEnd> FastDdsBus::call(const ServiceEndpoint& endpoint,
                                            ClientReceiver& receiver) {
  auto client =
      std::make_unique<DdsClient>(participant_, options_.ros_namespace, endpoint, receiver);
  auto made = std::make_unique<NodeClient>(nodes_, endpoint, std::move(client), own_calls_);
  watch_.notice();
  return made;
}

Callers FastDdsBus::callers() const {
  const std::string home =
      options_.ros_namespace.empty() ? "/" : "/" + options_.ros_namespace + "/";
  const auto own = own_calls_.all();
  std::set<std::string> called(own.begin(), own.end());
  for (const std::string& topic : participant_.remote_ends().written_topics("rq/")) {
    const auto service = ros_service(topic);
    if (service && service->name.compare(0, home.size(), home) == 0) {
      called.insert(service->name.substr(home.size()));
    }
  }
  return {participant_.remote_ends().has_ros2(), {called.begin(), called.end()}};
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
  topic.withdraw(source, now());
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

std::unique_ptr<HostGraph> FastDdsBus::open_graph() const {
  BusOptions options = options_;
  options.name += "_graph";
  return make_host_graph(options);
}

}  // namespace

std::unique_ptr<Bus> make_fast_dds_bus(const BusOptions& options) {
  return std::make_unique<FastDdsBus>(options);
}

}  // namespace tocsin
