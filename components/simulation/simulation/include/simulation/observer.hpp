// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "foundation/role.hpp"
#include "foundation/time.hpp"
#include "foundation/traffic_class.hpp"
#include "idl_support/topic_info.hpp"
#include "idl_support/type_info.hpp"
#include "radio_channel/radio_channel.hpp"
#include "runtime/bus.hpp"

namespace tocsin::simulation {

/// A topic in one process. Lives as long as the world, so that its address may serve as a key.
struct TopicEnd {
  std::string host;
  Role role = Role::uxv;  ///< of the host
  std::string process;
  std::string topic;
  std::optional<TrafficClass> traffic_class;  ///< of a link topic that it writes
  Scope scope = Scope::host;
  const TypeInfo* type = nullptr;
  double lifespan_s = 0;  ///< infinity: none
  bool reliable = false;
  bool keeps_one = true;  ///< depth 1: an older sample is worth nothing once a newer one is there
  bool pausable = false;  ///< its router's gate can close for it
  bool drops = false;     ///< and then its samples are dropped
  bool stored = false;    ///< what of it does not cross at first is backfilled
  bool durable = false;   ///< late readers get its last sample again
  std::string user_data;  ///< that its writers announce
};

/// A sample that a component wrote. Its readers on the same host have it already. A component need
/// not write what nobody reads.
struct Written {
  const TopicEnd& from;
  Time time;
  std::uint64_t sequence;  ///< from 1, each write of this end one more
  std::size_t bytes;       ///< serialised; 0 for a host topic
  const void* message;     ///< of type `from.type`; valid during the call
};

/// A sample, or a piece of one, that a router put on the radio, for the first time or again.
struct Sent {
  const TopicEnd& from;
  Time time;
  std::uint64_t sequence;  ///< on the link: from 1, counts only what was sent
  std::uint64_t written;   ///< Written::sequence
  std::size_t bytes;       ///< of what was sent
};

/// A sample that a router has given to its log.
struct LoggedSample {
  const TopicEnd& from;
  Time time;
  std::uint64_t written;  ///< Written::sequence
  std::uint64_t source;   ///< of its writer, as routers know it
};

/// On which topic a router has given a sample to its host.
enum class GivenAs : std::uint8_t { live, backfilled };

/// A sample that a router has given to its host, whoever reads it there.
struct GivenSample {
  const TopicEnd& from;
  const std::string& host;  ///< that it was given to
  Time time;
  std::uint64_t written;  ///< Written::sequence
  GivenAs as;
};

/// A sample that crossed the radio and was given to the readers of one process.
struct Delivered {
  const TopicEnd& from;
  const TopicEnd& to;
  std::uint64_t sequence;  ///< Sent::sequence
  std::uint64_t written;   ///< Written::sequence or 0
  Time written_at;         ///< when it was written; as `sent_at` when `written` is 0
  Time sent_at;            ///< when it left the gate
  Time received;
  std::size_t bytes;
  const void* message;
};

/// One echo request of network_monitor, when it is sent and, unless it is lost, when it is back.
struct Echo {
  const std::string& host;
  std::uint16_t sequence;
  Time sent;
  Time received;  ///< `never` at sending
};

/// Where a base truly is.
struct BasePosition {
  const std::string& host;
  Time time;
  double x_m;
  double y_m;
  double heading_rad;
  double speed_mps;
  double turn_rate_radps;
  Time commanded;                  ///< when bytes last came from the computer; Time::min() never
  bool commanded_to_stand = true;  ///< by the last velocity from the computer; there was none: true
};

enum class ProcessEvent : std::uint8_t { started, killed, exited, frozen, thawed };

struct ProcessChange {
  const std::string& process;  ///< host/name
  ProcessEvent event;
  Time time;
  int exit_code;  ///< of one that exited
};

enum class GateEvent : std::uint8_t {
  closed,
  opened,
  gone,  ///< the router has ended, with all that waited in it; the next one begins open
};

/// What happened to the gate of a host's router.
struct GateChange {
  const std::string& host;
  Time time;
  GateEvent event;
};

/// Sees what happens in a simulated world, in the thread that runs it. Overwrite what is wanted;
/// it must not change the world. It costs nothing when there is none.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void on_written(const Written&) {}
  virtual void on_sent(const Sent&) {}
  virtual void on_logged(const LoggedSample&) {}
  virtual void on_given(const GivenSample&) {}
  virtual void on_delivered(const Delivered&) {}
  virtual void on_echo(const Echo&) {}
  /// Each second: what a Wi-Fi driver would tell, airtime and loss counts of both directions.
  virtual void on_channel(const radio::LinkReport&, Time) {}
  /// Ten times a second.
  virtual void on_position(const BasePosition&) {}
  virtual void on_gate(const GateChange&) {}
  /// Not at the start of the world.
  virtual void on_process(const ProcessChange&) {}
  /// A component threw `what` and is ticked no more.
  virtual void on_failure(const std::string& /*component*/, const std::string& /*what*/, Time) {}
  /// Everything due at this instant is done. Not told of packets that complete no sample.
  virtual void on_step(Time) {}
};

}  // namespace tocsin::simulation
