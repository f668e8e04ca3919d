// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "foundation/time.hpp"

namespace tocsin {

class HostGraph;
struct QosChange;

/// Account of one writer or reader of this process towards other processes, since start.
struct EndpointHealth {
  std::string topic;
  bool writer = false;         ///< else a reader
  std::uint64_t samples = 0;   ///< written, or received
  std::uint64_t lost = 0;      ///< refused by the middleware, or known to be missed by the reader
  std::uint64_t rejected = 0;  ///< received, but not of the topic's type
  int matched = 0;             ///< other ends now
  std::uint64_t incompatible_qos = 0;  ///< times that an end was found whose QoS does not fit
  std::string incompatible_policy;     ///< DDS name of the policy that did not fit last
  std::string misfit;      ///< policies by which an end that is there now does not fit, and whose
  std::string other_type;  ///< of an end that has another type or layout now, and its participant
  std::uint64_t deadlines_missed = 0;
  std::uint64_t liveliness_lost = 0;  ///< times that a writer stopped to be alive
  std::uint64_t thinned = 0;          ///< dropped by max_rate_hz or minimum_separation_s
  Time last{};                        ///< of the last sample; zero: none yet
};

/// Who asks from outside of this process.
struct Callers {
  bool ros2 = false;                       ///< a participant of ROS 2 that is none of ours is there
  std::vector<std::string> services = {};  ///< that somebody calls, as service_name gives them
};

/// What a container needs of the middleware besides topics and services. A bus that is on no host,
/// as those of tests are, has nothing to tell and nothing to change.
class HostControl {
 public:
  virtual ~HostControl() = default;
  /// Of the bus's topics, without slashes; empty for none.
  [[nodiscard]] virtual const std::string& ros_namespace() const;
  /// Of every DDS endpoint of this process. Thread-safe.
  [[nodiscard]] virtual std::vector<EndpointHealth> health() const { return {}; }
  /// Changes policies of this process's ends of a topic while they are in use. The number of these
  /// ends; 0: there are none. Throws ConfigError for what cannot change. Thread-safe.
  virtual int change_qos(const QosChange& /*change*/) { return 0; }
  /// Who asks from outside. Thread-safe.
  [[nodiscard]] virtual Callers callers() const { return {}; }
  /// `notice` is called, by any thread, when that may have changed; it must not block. Empty ends
  /// it, and waits for a call that is running.
  virtual void watch_callers(const std::function<void()>& /*notice*/) {}
  /// Tells ROS 2's peers which nodes this process has, when that or the peers have changed. Called
  /// now and then by one thread of the process.
  virtual void update_graph() {}
  /// Looks at the host's domain by a participant of its own, which hears this bus, too. Null: the
  /// bus is on none. Throws EnvironmentError when the participant cannot be created.
  [[nodiscard]] virtual std::unique_ptr<HostGraph> open_graph() const;
};

}  // namespace tocsin
