// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <unordered_map>
#include <vector>

#include "control.hpp"
#include "foundation/datagram_socket.hpp"
#include "foundation/file_descriptor.hpp"
#include "foundation/time.hpp"
#include "options.hpp"
#include "radio_channel/radio_channel.hpp"
#include "statistics.hpp"
#include "tun.hpp"

namespace tocsin::link {

/// The channel that the files of the options describe. Throws ConfigError.
[[nodiscard]] radio::RadioChannel make_channel(const Options& options, Time start);

/// The program: an interface for each vehicle and each station, the channel between them, control,
/// statistics; one thread. Stations are on one wire behind the access point.
///
/// What may fail fails in the constructor (ConfigError, EnvironmentError). While running, a full
/// disk or a refused packet is counted or shows as a missing line, and the link goes on. When
/// somebody deletes an interface, its packets are lost and the wireless file no longer has it.
class Emulator {
 public:
  explicit Emulator(const Options& options);
  /// Until SIGTERM or SIGINT; then the interfaces are removed.
  void run();

 private:
  /// One vehicle's side.
  struct Vehicle {
    Vehicle(const Options& options, std::size_t index);
    End end;
    std::uint32_t address;  ///< in network byte order
    Tun tun;
    std::unique_ptr<DatagramSocket> control = {};
    std::unique_ptr<StatsFile> stats = {};
    std::string wireless_path;
  };
  struct Station {
    Station(const Options& options, std::size_t index);
    End end;
    std::uint32_t address;  ///< in network byte order
    Tun tun;
  };
  using Bytes = std::vector<std::uint8_t>;

  void watch(int fd);
  void wait();
  void handle(int fd);
  void carry_from(std::size_t vehicle);
  void carry_from_station(Station& station);
  /// To the stations that a packet is for.
  void send_on_wire(const Bytes& packet);
  [[nodiscard]] bool is_for_station(const Bytes& packet) const;
  /// A packet of a station, or one that the access point sends on.
  void send_down(const Bytes& packet);
  void push(radio::Direction direction, std::size_t vehicle, Bytes packet);
  void forget(const Tun& tun, const End& end);
  void deliver();
  void deliver(const radio::Outcome& outcome, const Bytes& packet);
  void obey(const std::string& datagram, std::size_t vehicle);
  void apply(const SetParameter& command);
  void report();
  void report(std::size_t vehicle, Time now);
  [[nodiscard]] static std::error_code write_wireless(const Vehicle& vehicle,
                                                      const std::string& text);

  Options options_;
  FileDescriptor signals_;
  FileDescriptor epoll_;
  FileDescriptor timer_;
  Time start_;
  radio::RadioChannel channel_;
  std::deque<Vehicle> vehicles_;
  std::deque<Station> stations_;
  std::unordered_map<radio::FrameId, Bytes> packets_;  // on their way
  EmulatorCounters counters_;
  Time tick_at_;
  Time report_at_;
  bool running_ = true;
};

}  // namespace tocsin::link
