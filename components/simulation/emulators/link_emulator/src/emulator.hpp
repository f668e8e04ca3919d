// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
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

/// The program: two interfaces, the channel between them, control, statistics; one thread.
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
  void watch(int fd);
  void wait();
  void handle(int fd);
  void carry(radio::Direction direction);
  void forget(const Tun& end, const std::string& name);
  void deliver();
  void obey(const std::string& datagram);
  void apply(const SetParameter& command);
  void report();
  [[nodiscard]] std::error_code write_wireless(const std::string& text) const;

  Options options_;
  FileDescriptor signals_;
  FileDescriptor epoll_;
  FileDescriptor timer_;
  Time start_;
  radio::RadioChannel channel_;
  Tun uxv_;
  Tun gcs_;
  std::unique_ptr<DatagramSocket> control_;
  std::unique_ptr<StatsFile> stats_;
  std::unordered_map<radio::FrameId, std::vector<std::uint8_t>> packets_;  // on their way
  EmulatorCounters counters_;
  Time tick_at_;
  Time report_at_;
  bool running_ = true;
};

}  // namespace tocsin::link
