// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>

#include "idl_support/type_info.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"

namespace tocsin {

/// A DDS peer that belongs to no launch: a process of its own in the network of another one. It is
/// killed in the end, without a chance to say anything.
class Peer {
 public:
  /// Does `job` there, on a bus of these domains; the job should not end.
  Peer(pid_t process, const BusOptions& domains, const std::function<void(Bus&)>& job);
  /// The same without a bus.
  Peer(pid_t process, const std::function<void()>& job);
  ~Peer();
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  void kill();
  /// It computes and hears nothing until it is resumed.
  void stop();
  void resume();

 private:
  pid_t pid_;
};

/// A peer's domains on a host.
[[nodiscard]] BusOptions on_host(int domain);

/// Repeats a message for ever, twenty times a second unless told otherwise.
template <class Topic>
std::function<void(Bus&)> repeat(typename Topic::Message message,
                                 std::chrono::milliseconds period = std::chrono::milliseconds(50)) {
  return [message = std::make_shared<const typename Topic::Message>(std::move(message)),
          period](Bus& bus) {
    const auto writer = bus.advertise({Topic::info, &type_info<typename Topic::Message>()});
    for (;;) {
      (void)writer->write(message);
      std::this_thread::sleep_for(period);
    }
  };
}

/// Since the Unix epoch [s].
[[nodiscard]] double wall_s();

/// Writes every velocity of the wheels to a file: wall time [s] and speed [m/s].
[[nodiscard]] std::function<void(Bus&)> watch_wheels(const std::string& file);
/// When, by that file, the vehicle last moved faster than 1 cm/s [s since the epoch]; 0 never.
[[nodiscard]] double last_moved(const std::string& file);
/// When the file was last written [s since the epoch], so that silence is not taken for standing.
[[nodiscard]] double last_seen(const std::string& file);

}  // namespace tocsin
