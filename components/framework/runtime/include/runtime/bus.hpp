// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "foundation/time.hpp"
#include "idl_support/topic_info.hpp"
#include "idl_support/type_info.hpp"
#include "runtime/detail/services.hpp"

namespace tocsin {

class HostControl;
class LinkAccess;

/// Whether a reader is of use without a writer; for `tocsin check`, no bus looks at it.
enum class Writers { needed, optional };

/// A writer that a subscription hears now.
struct WriterInfo {
  std::string name;       ///< of its participant, as discovery tools show it; not unique
  std::string user_data;  ///< all that it announces
  double lifespan_s = std::numeric_limits<double>::infinity();  ///< of its samples
};

/// What became of a write.
enum class [[nodiscard]] Status{
    ok,      ///< Handed to every reader on this host, its link_router among them.
    failed,  ///< The middleware refused it (history full, or shutting down); counted.
};

/// Of an instance, a value of the key of a topic's type: disposed by a writer, or left by all.
enum class InstanceState : std::uint8_t { alive, disposed, no_writers };

/// One message with what is known of its way here.
struct Sample {
  std::shared_ptr<const void> message;
  Time received{};                    ///< when it reached this process, or its writer's tick began
  std::int64_t sent_wall_ns = 0;      ///< [ns] since the Unix epoch, writer's clock
  std::int64_t received_wall_ns = 0;  ///< [ns] since the Unix epoch, own clock
  std::uint64_t sequence = 0;  ///< of the writer, gaps are samples that never came; 0 unknown
  std::uint64_t source = 0;    ///< identifies the writer; changes when it restarts
  std::uint32_t bytes = 0;     ///< serialised size; 0 when it was handed over unserialised
  InstanceState state = InstanceState::alive;
  std::uint64_t instance = 0;  ///< the same for the same key; 0: the type has no key
};

/// Takes samples off a bus. Called from any thread; must not block.
struct Receiver {
  virtual ~Receiver() = default;
  virtual void receive(const Sample& sample) = 0;
  /// Called instead when nobody gets it after this one, who may move from it.
  virtual void receive_last(Sample&& sample) { receive(sample); }
  /// An instance has ended: `sample` has its state and no message.
  virtual void instance_ended(const Sample& /*sample*/) {}
};

/// One end of a topic, as the bus sees it.
struct Endpoint {
  TopicInfo topic;
  const TypeInfo* type;
  Writers writers = Writers::needed;
  const char* user_data = "";  ///< "key=value;" of a writer, announced beside what its profile says
  std::string node = "";       ///< of ROS 2 that has it; empty: none
};

/// Subscribed as long as it lives. Destroying it waits for a running `receive`.
struct Subscription {
  virtual ~Subscription() = default;
  /// The writer with this `Sample::source`; empty when it is gone: closed, or its process was not
  /// heard for the lease of its participant (5 s on a host, 60 s over the link). Thread-safe.
  [[nodiscard]] virtual std::optional<WriterInfo> writer(std::uint64_t /*source*/) const {
    return {};
  }
};

/// The writing end of a topic.
class Publication {
 public:
  virtual ~Publication() = default;
  /// Thread-safe; never blocks on the network. The message must not change afterwards.
  virtual Status write(const std::shared_ptr<const void>& message) = 0;
  /// Ends the instance of the message's key: it is no more (disposed), or this does not write it
  /// any more (no_writers). Failed: no key, not written before, or the bus has no instances.
  virtual Status end_instance(const std::shared_ptr<const void>& /*message*/,
                              InstanceState /*how*/) {
    return Status::failed;
  }
  /// False: nobody would notice a write, now or as a late joiner. Thread-safe.
  [[nodiscard]] virtual bool has_readers() const { return true; }
  /// Whether somebody reads now. Thread-safe.
  [[nodiscard]] virtual bool is_read() const { return has_readers(); }
};

/// The only seam between components and the middleware.
class Bus {
 public:
  virtual ~Bus() = default;

  /// Throws ConfigError when the topic's QoS profile is missing or its type clashes with the one
  /// that another endpoint of this process uses. `receiver` must outlive the result.
  virtual std::unique_ptr<Subscription> subscribe(const Endpoint& endpoint, Receiver& receiver) = 0;
  virtual std::unique_ptr<Publication> advertise(const Endpoint& endpoint) = 0;

  /// Serves, or calls, a service; null: this bus has none. `receiver` must outlive the result.
  virtual std::unique_ptr<ServerEnd> serve(const ServiceEndpoint& /*endpoint*/,
                                           ServerReceiver& /*receiver*/) {
    return nullptr;
  }
  virtual std::unique_ptr<ClientEnd> call(const ServiceEndpoint& /*endpoint*/,
                                          ClientReceiver& /*receiver*/) {
    return nullptr;
  }
  /// The clock of this bus: real, or virtual in a simulation.
  [[nodiscard]] virtual Time now() const = 0;
  [[nodiscard]] virtual std::int64_t wall_ns(Time t) const = 0;  ///< [ns], for stamps only

  /// What a container looks at and changes. It lives as long as the bus.
  [[nodiscard]] virtual HostControl& host_control();
  /// For link_router: its host's way over the radio. Null: this process has none.
  [[nodiscard]] virtual LinkAccess* link_access() { return nullptr; }
};

}  // namespace tocsin
