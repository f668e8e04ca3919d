// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "runtime/detail/services.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"
#include "runtime/middleware/qos_policies.hpp"

namespace tocsin {

/// The bytes of a GUID: 12 of its participant, 4 of the endpoint.
using Gid = std::array<std::uint8_t, 16>;

/// "01.0f.4c..." as `ros2 topic info -v` shows it.
[[nodiscard]] std::string text_of(const Gid& gid);

/// A node and the ends that it has.
struct GraphNode {
  std::string ros_namespace;  ///< "/" or "/name"
  std::string name;
  std::vector<Gid> readers = {};
  std::vector<Gid> writers = {};

  /// "/name" or "/namespace/name".
  [[nodiscard]] std::string path() const {
    return (ros_namespace == "/" ? "" : ros_namespace) + "/" + name;
  }
};
[[nodiscard]] bool operator==(const GraphNode& one, const GraphNode& other);

/// One end of a topic that a participant of a host has announced.
struct GraphEnd {
  std::string topic;        ///< on the wire: `rt/odom`
  std::string type;         ///< on the wire: `nav_msgs::msg::dds_::Odometry_`
  std::string participant;  ///< name of its participant
  Gid gid{};
  bool writer = false;
  QosContract qos = {};                                         ///< what it offers or requests
  double lifespan_s = std::numeric_limits<double>::infinity();  ///< of a writer
  std::string user_data = "";
};

/// A message of any type.
struct RawSample {
  std::shared_ptr<const std::vector<std::uint8_t>> bytes;  ///< encapsulation header included
  std::uint64_t source = 0;                                ///< as in Sample
  std::uint64_t sequence = 0;
  std::int64_t sent_wall_ns = 0;  ///< [ns] since the Unix epoch, writer's clock
  Time received{};
  std::int64_t received_wall_ns = 0;  ///< [ns] since the Unix epoch, own clock
};

/// A topic as it stands on the wire, and what is asked of its other ends.
struct RawTopic {
  std::string name;
  std::string type;
  bool reliable = false;
  bool transient_local = false;
};

/// How to read what these writers of one topic write so that each is heard: reliable and with the
/// last samples where all offer it. There is at least one; when their types differ, the first
/// counts.
[[nodiscard]] RawTopic readable(const std::vector<const GraphEnd*>& writers);

/// Reads as long as it lives.
class RawReading {
 public:
  virtual ~RawReading() = default;
};

class RawWriting {
 public:
  virtual ~RawWriting() = default;
  /// An encoded message with its encapsulation header. False when the middleware refused it.
  virtual bool write(const std::vector<std::uint8_t>& bytes) = 0;
  /// Readers that were matched since it was made. Any thread.
  [[nodiscard]] virtual int readers() const = 0;
};

/// Who is on a host's domain, and topics of any type there, known or not: for tools.
class HostGraph {
 public:
  virtual ~HostGraph() = default;
  /// All ends of other participants that were heard so far, by topic and type. Any thread.
  [[nodiscard]] virtual std::vector<GraphEnd> ends() const = 0;
  /// The nodes that others have told so far, by path. Any thread.
  [[nodiscard]] virtual std::vector<GraphNode> nodes() const = 0;
  /// `on_sample` is called by another thread, one sample at a time.
  [[nodiscard]] virtual std::unique_ptr<RawReading> read(
      const RawTopic& topic, std::function<void(RawSample&&)> on_sample) = 0;
  /// Keeps its last 10 samples, or the last one for late readers.
  /// Calls a service; its name begins with a slash. `receiver` must outlive the result.
  [[nodiscard]] virtual std::unique_ptr<ClientEnd> call(const ServiceEndpoint& endpoint,
                                                        ClientReceiver& receiver) = 0;
  [[nodiscard]] virtual std::unique_ptr<RawWriting> write(const RawTopic& topic) = 0;
  /// Offers `qos`, in which reliability and durability stand, too.
  [[nodiscard]] virtual std::unique_ptr<RawWriting> write(const RawTopic& topic,
                                                          const QosProfile& qos) = 0;
};

/// All ends that `graph` hears, once nothing new has come for a while; after `patience`, or when
/// `is_over` says so, in any case. Waits in real time.
[[nodiscard]] std::vector<GraphEnd> settled_ends(const HostGraph& graph, Duration patience,
                                                 const std::function<bool()>& is_over = {});

/// Throws EnvironmentError when the participant cannot be created.
[[nodiscard]] std::unique_ptr<HostGraph> make_host_graph(const BusOptions& options);

}  // namespace tocsin
