// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>
#include <sys/types.h>

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "foundation/temporary_folder.hpp"

namespace tocsin::link {

/// Three network namespaces of this process; they vanish with it. With the environment variable
/// TOCSIN_TEST_USERNS they lie in a user namespace of their own.
class Namespaces {
 public:
  /// Why namespaces or TUN cannot be had here; empty when they can.
  [[nodiscard]] static const std::string& missing();
  /// Paths for `--end`, valid in children too.
  [[nodiscard]] static std::string uxv();
  [[nodiscard]] static std::string second_uxv();
  [[nodiscard]] static std::string gcs();
};

/// A UDP socket inside a namespace, bound to address:port and connected to the peer.
class UdpSocket {
 public:
  UdpSocket(const std::string& netns, const std::string& address, const std::string& peer);
  ~UdpSocket();
  UdpSocket(const UdpSocket&) = delete;
  UdpSocket& operator=(const UdpSocket&) = delete;
  /// The DSCP of what is sent from now on.
  void set_dscp(int dscp);
  /// Sends a numbered datagram of `bytes`.
  void send(int number, std::size_t bytes);
  /// The number of the next datagram; empty when none comes within `timeout_ms`.
  [[nodiscard]] std::optional<int> receive(int timeout_ms);

 private:
  int fd_;
};

/// What the kernel says of wlan0 in a namespace.
struct InterfaceState {
  bool exists;
  bool carrier;
  std::string address;
};
[[nodiscard]] InterfaceState interface_state(const std::string& netns);
/// Until wlan0 has no carrier (the kernel tells up to a second late); false after 5 s.
[[nodiscard]] bool loses_carrier(const std::string& netns);
/// Deletes wlan0, as `ip link del` does. False when that fails.
[[nodiscard]] bool delete_interface(const std::string& netns);

enum class Third { none, vehicle, station };

/// The program under test, in a directory of its own. With two vehicles, `uxv` and `uxv2` at
/// 10.77.0.3, the files of each begin with its name.
class Emulator {
 public:
  /// Starts it; `channel` is the text of the channel file. Does not wait.
  explicit Emulator(const std::string& channel, Third third = Third::none);
  ~Emulator();
  Emulator(const Emulator&) = delete;
  Emulator& operator=(const Emulator&) = delete;

  void start();
  /// Until both interfaces carry and the files are there; false after 5 s.
  [[nodiscard]] bool ready() const;
  void command(const std::string& text, const std::string& socket = "control") const;
  void signal(int number) const;
  /// The exit code, or minus the signal that killed it.
  int wait();
  /// The last line of statistics that was written after this call; null after 5 s.
  [[nodiscard]] nlohmann::json next_stats() const;
  /// Processor time that it has used.
  [[nodiscard]] double cpu_s() const;
  [[nodiscard]] std::string file(const std::string& name) const;

 private:
  [[nodiscard]] std::vector<std::string> words() const;
  const TemporaryFolder folder_;
  const Third third_;
  pid_t pid_ = -1;
};

/// A channel that loses nothing.
inline const char* const open_channel = "radio_channel: {tx_dbm: 30, shadowing_sigma_db: 0}";

/// Tests of the program between two real namespaces.
class LinkEmulator : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!Namespaces::missing().empty()) GTEST_SKIP() << Namespaces::missing();
  }
};

/// A socket on each side.
struct Ends {
  UdpSocket uxv{Namespaces::uxv(), "10.77.0.1", "10.77.0.2"};
  UdpSocket gcs{Namespaces::gcs(), "10.77.0.2", "10.77.0.1"};
};

/// What a program prints to stderr, and its exit code.
struct ProgramEnd {
  int code;
  std::string text;
};
/// Runs the program to its end; without the capabilities to enter namespaces on demand.
[[nodiscard]] ProgramEnd run_to_end(std::vector<std::string> arguments, bool without_privilege);

}  // namespace tocsin::link
