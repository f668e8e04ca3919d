// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pacer.hpp"
#include "rtps.hpp"
#include "runtime/bus.hpp"
#include "runtime/middleware/qos_profile.hpp"
#include "runtime/middleware/replay_filter.hpp"
#include "runtime/middleware/topic_exchange.hpp"
#include "runtime/middleware/traffic_rules.hpp"

namespace tocsin::simulation {

class SimHost;
class SimLinkBus;
struct Freight;
struct HostTopic;

/// All link endpoints of the world, so that they find each other; in the order of their making.
class LinkEndpoints {
 public:
  void add(const std::string& topic, const SimHost& host, RtpsWriter& writer);
  void add(const std::string& topic, const SimHost& host, RtpsReader& reader);
  void remove(const std::string& topic, const RtpsWriter& writer);
  void remove(const std::string& topic, const RtpsReader& reader);
  /// The living writer with this source.
  [[nodiscard]] std::optional<WriterInfo> writer(const std::string& topic,
                                                 std::uint64_t source) const;
  /// Those that are added from now on find the others after this time only.
  void set_discovery(Core& core, Duration takes) {
    core_ = &core;
    discovery_ = takes;
  }

 private:
  template <class End>
  struct Entry {
    const SimHost* host;
    End* end;
  };
  struct Topic {
    std::vector<Entry<RtpsWriter>> writers;
    std::vector<Entry<RtpsReader>> readers;
  };
  void match(RtpsWriter& writer, RtpsReader& reader);
  std::map<std::string, Topic> topics_;
  Core* core_ = nullptr;
  Duration discovery_{0};
};

/// What the hosts of a world have in common.
struct Network {
  Core& core;
  RadioLink& link;
  QosProfiles qos;
  LinkEndpoints endpoints;
  std::map<std::string, SimLinkBus*> routers = {};  ///< that live, by the name of their host
  PeerId router_lives = 0;
  /// The living router with this life; null: it has died.
  [[nodiscard]] SimLinkBus* find_router(PeerId life) const;
};

/// The bus of one simulated process (container).
///
/// A sample goes at once and in order to every reader on its host; for link topics also through
/// the gate of this process, as CDR in packets, to each process with a reader on another host.
class SimProcess final : public Bus {
 public:
  /// `life`: how often it was started before.
  SimProcess(Network& network, SimHost& host, std::string name, int life);
  ~SimProcess() override;

  std::unique_ptr<Subscription> subscribe(const Endpoint& endpoint, Receiver& receiver) override;
  std::unique_ptr<Publication> advertise(const Endpoint& endpoint) override;
  [[nodiscard]] Time now() const override { return network_.core.now; }
  [[nodiscard]] std::int64_t wall_ns(Time t) const override;
  std::unique_ptr<LinkBus> open_link(const std::function<void()>& on_event) override;
  void set_gate(bool open) override;
  [[nodiscard]] std::vector<TopicTraffic> link_traffic() const override;

  /// One topic in this process.
  struct Topic {
    Topic(const Endpoint& its, const QosProfile& profile);
    Endpoint endpoint;
    TopicEnd end;
    Origin origin;  ///< of the last write
    QosProfile qos;
    bool keeps_last;
    TopicExchange kept;  ///< gives late readers what they are promised
    std::vector<Receiver*> receivers;
    void attach(Receiver& receiver);
    void detach(Receiver& receiver);
    /// To the components of this process.
    void deliver(const Sample& sample);
    HostTopic* on_host = nullptr;
    std::unique_ptr<RtpsReader> reader;
    RtpsWriter* writer = nullptr;  ///< owned by `gated`
    std::unique_ptr<GatedWriter> gated;
    std::uint64_t source = 0;
    bool writes = false;
    ReplayFilter carried;  ///< what routers have brought
    [[nodiscard]] bool reads() const { return !receivers.empty(); }
    std::uint64_t written = 0;
    std::string label;  ///< host/process/topic
  };
  Status write(Topic& topic, const std::shared_ptr<const void>& message);
  [[nodiscard]] std::optional<WriterInfo> writer(const Topic& topic, std::uint64_t source) const;
  /// All that it had is lost, and nobody hears of it any more. Its components are gone before.
  void die();

 private:
  Topic& topic(const Endpoint& endpoint);
  std::unique_ptr<Topic> make_topic(const Endpoint& endpoint);
  void report(const Topic& topic, const void* message, Status status) const;
  void receive(Topic& topic, const Change& change, std::uint64_t source);
  void make_reader(Topic& topic);
  void make_writer(Topic& topic);
  void begin_to_write(Topic& topic);
  [[nodiscard]] Pacer* pacer(const QosProfile& qos);
  Network& network_;
  SimHost& host_;
  std::string name_;
  int life_;
  bool gate_open_ = true;
  std::map<std::string, std::unique_ptr<Pacer>> pacers_;  ///< by the name of the flow controller
  std::map<std::string, std::unique_ptr<Topic>> topics_;
};

/// One topic on a host.
struct HostTopic {
  const TypeInfo* type = nullptr;
  std::vector<SimProcess::Topic*> processes;
  std::map<std::uint64_t, Sample> last = {};         ///< of its own writers, by source
  std::map<std::string, Sample> last_carried = {};   ///< by peer and user data: one per flow
  std::map<std::uint64_t, WriterInfo> carried = {};  ///< writers on other hosts, by source
};

/// One side of the radio link: its processes and what they tell each other.
class SimHost {
 public:
  /// `routed`: its router alone speaks on the link.
  SimHost(Network& network, std::string name, std::string role, const std::string& traffic_file,
          bool routed = false);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const std::string& role() const { return role_; }
  [[nodiscard]] const TrafficRules& rules() const { return rules_; }
  [[nodiscard]] radio::Direction direction() const;

  [[nodiscard]] bool routed() const { return routed_; }
  /// Null: it has none now. A new one learns of the writers and of the last samples of states.
  void set_router(SimLinkBus* router);
  [[nodiscard]] SimLinkBus* router() const { return router_; }
  /// To all readers of this host what a router has carried here.
  void give(const Flow& flow, const CarriedSample& sample, const Freight& freight);

  SimProcess& add_process(const std::string& name, int life = 0);
  /// Sets the wall clock of this host so much on.
  void jump(Duration by) { clock_offset_ += by; }
  [[nodiscard]] Duration clock_offset() const { return clock_offset_; }
  /// A process that read and wrote a topic has died.
  static void detach(SimProcess::Topic& topic);
  /// A process has begun to read a topic; gets the last samples of those that are kept.
  void attach(SimProcess::Topic& topic);
  /// Hands a sample to every process of this host.
  static void deliver(const SimProcess::Topic& from, const Sample& sample);
  /// Whether a component of this host reads it.
  [[nodiscard]] static bool has_readers(const SimProcess::Topic& topic);

 private:
  Network& network_;
  std::string name_;
  std::string role_;
  TrafficRules rules_;
  const bool routed_;
  SimLinkBus* router_ = nullptr;
  std::map<std::string, HostTopic> topics_;
  std::list<SimProcess> processes_;  ///< the dead too, since packets on the air refer to them
  Duration clock_offset_{0};
};

}  // namespace tocsin::simulation
