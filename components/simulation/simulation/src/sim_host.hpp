// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "foundation/role.hpp"
#include "foundation/stop_value.hpp"
#include "radio_link.hpp"
#include "runtime/bus.hpp"
#include "runtime/middleware/link_bus.hpp"
#include "runtime/middleware/local_services.hpp"
#include "runtime/middleware/qos_profile.hpp"
#include "runtime/middleware/replay_filter.hpp"
#include "runtime/middleware/topic_exchange.hpp"
#include "runtime/middleware/traffic_rules.hpp"

namespace tocsin::simulation {

class SimHost;
class SimLinkBus;
struct Freight;
struct HostTopic;

/// What a router puts on the radio, as anybody there can hear it.
struct Overheard {
  PeerId from = 0;  ///< the router
  FlowId flow = 0;  ///< 0: the stop's value alone
  std::uint64_t number = 0;
  CarriedSample sample;
  SamplePiece piece;
  std::shared_ptr<const StopValue> stop;  ///< null: it was no part of this
};

/// What a vehicle and its station have in common, and no other vehicle has.
struct Network {
  Core& core;
  RadioLink& link;
  QosProfiles qos;
  RadioLink* second_link = nullptr;                 ///< null: there is one path
  std::size_t vehicle = 0;                          ///< of several
  std::map<std::string, SimLinkBus*> routers = {};  ///< that live, by the name of their host
  PeerId router_lives = 0;
  /// Of what serves all vehicles: where the topics of each are, by host and namespace.
  std::map<std::pair<std::string, std::string>, SimHost*> homes = {};
  /// What the logs of routers hold instead of encoded samples, by number: outlives their routers.
  std::vector<std::shared_ptr<const void>> logged = {};
  std::function<void(const Overheard&)> on_air = {};  ///< empty: nobody listens
  /// Null: nobody looks.
  [[nodiscard]] Observer* observer() const { return core.observer(vehicle); }
  /// The living router with this life; null: it has died.
  [[nodiscard]] SimLinkBus* find_router(PeerId life) const;
};

/// The bus of one simulated process (container).
///
/// A sample goes at once and in order to every reader on its host, and to the host's router.
class SimProcess final : public Bus, private LinkAccess {
 public:
  /// `life`: how often it was started before.
  SimProcess(Network& network, SimHost& host, std::string name, int life);
  ~SimProcess() override;

  std::unique_ptr<Subscription> subscribe(const Endpoint& endpoint, Receiver& receiver) override;
  std::unique_ptr<Publication> advertise(const Endpoint& endpoint) override;
  /// With every process of this host.
  std::unique_ptr<ServerEnd> serve(const ServiceEndpoint& endpoint,
                                   ServerReceiver& receiver) override;
  std::unique_ptr<ClientEnd> call(const ServiceEndpoint& endpoint,
                                  ClientReceiver& receiver) override;
  [[nodiscard]] Time now() const override { return network_.core.now; }
  [[nodiscard]] std::int64_t wall_ns(Time t) const override;
  [[nodiscard]] LinkAccess* link_access() override { return this; }
  /// Frozen, its link takes and sends no packet; what its host writes waits for it.
  void freeze(bool frozen) { frozen_ = frozen; }
  [[nodiscard]] bool is_frozen() const { return frozen_; }

  /// One topic in this process.
  struct Topic {
    Topic(const Endpoint& its, const QosProfile& profile);
    Endpoint endpoint;
    TopicEnd end;
    QosProfile qos;
    bool keeps_last;
    TopicExchange kept;  ///< gives late readers what they are promised
    std::vector<Receiver*> receivers;
    void attach(Receiver& receiver);
    void detach(Receiver& receiver);
    /// To the components of this process.
    void deliver(const Sample& sample);
    HostTopic* on_host = nullptr;
    SimHost* home = nullptr;  ///< whose topic it is
    std::uint64_t source = 0;
    bool writes = false;
    ReplayFilter carried;  ///< what routers have brought
    [[nodiscard]] bool reads() const { return !receivers.empty(); }
    std::uint64_t written = 0;
    std::string label;  ///< host/process/topic
  };
  Status write(Topic& topic, const std::shared_ptr<const void>& message);
  [[nodiscard]] std::optional<WriterInfo> writer(const Topic& topic, std::uint64_t source) const;
  /// A component reads the topic, or does not any more.
  void tell_router(const Topic& topic) const;
  /// All that it had is lost, and nobody hears of it any more. Its components are gone before.
  void die();

 private:
  std::unique_ptr<LinkBus> open_link(const std::function<void()>& on_event) override;
  Topic& topic(const Endpoint& endpoint);
  std::unique_ptr<Topic> make_topic(const Endpoint& endpoint);
  void report(const Topic& topic, const void* message) const;
  void begin_to_write(Topic& topic);
  Network& network_;
  SimHost& host_;
  std::string name_;
  int life_;
  bool frozen_ = false;
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
  SimHost(Network& network, std::string name, Role role, const std::string& traffic_file,
          VehicleChain chain = VehicleChain::ours);

  /// Of a vehicle that has several, by preference; before its router runs.
  void set_sites(std::vector<std::string> sites) { sites_ = std::move(sites); }
  [[nodiscard]] const std::vector<std::string>& sites() const { return sites_; }

  /// Whose topic one is that a process of this host names.
  [[nodiscard]] SimHost& home_of(const std::string& topic);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] Observer* observer() const { return network_.observer(); }
  [[nodiscard]] Role role() const { return role_; }
  [[nodiscard]] const TrafficRules& rules() const { return rules_; }
  [[nodiscard]] radio::Direction direction() const;

  /// Null: it has none now. A new one learns of the writers and of the last samples of states.
  /// States that the one before had carried here are lost for late readers.
  void set_router(SimLinkBus* router);
  [[nodiscard]] SimLinkBus* router() const { return router_; }
  /// To all readers of this host what a router has carried here; nothing of a message between
  /// routers, which no host has written.
  void deliver_carried(const Flow& flow, const CarriedSample& sample, const Freight& freight);

  [[nodiscard]] LocalServices& services() { return services_; }
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
  [[nodiscard]] bool reads(const std::string& topic) const;
  /// The last sample of a writer of states; null: it has none.
  [[nodiscard]] static const Sample* last_of(const SimProcess::Topic& topic);

 private:
  Network& network_;
  std::string name_;
  Role role_;
  TrafficRules rules_;
  std::vector<std::string> sites_;
  SimLinkBus* router_ = nullptr;
  std::map<std::string, HostTopic> topics_;
  LocalServices services_;
  std::list<SimProcess> processes_;  ///< the dead too, since packets on the air refer to them
  Duration clock_offset_{0};
};

}  // namespace tocsin::simulation
