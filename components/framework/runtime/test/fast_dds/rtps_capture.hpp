// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace tocsin {

/// One RTPS submessage of interest seen on loopback.
struct CapturedSubmessage {
  std::uint8_t kind;           ///< 0x15 DATA, 0x16 DATA_FRAG, 0x07 HEARTBEAT, 0x06 ACKNACK
  std::uint32_t writer;        ///< writer entity id; its low byte tells builtin (0xc2, 0xc3) apart
  std::uint16_t port;          ///< UDP destination port
  std::uint32_t packet_bytes;  ///< of the whole IP packet
  bool statistics;             ///< the packet ends with 60 bytes of Fast DDS's statistics
  int dscp;                    ///< of its IP header
  [[nodiscard]] bool builtin() const { return (writer & 0xC0U) == 0xC0U; }
};

/// Listens on the loopback interface with a packet socket (needs CAP_NET_RAW) from construction to
/// destruction.
class RtpsCapture {
 public:
  RtpsCapture();
  ~RtpsCapture();
  /// False when the packet socket could not be opened.
  [[nodiscard]] bool ok() const { return socket_ >= 0; }
  /// What was sent between the last call and this one: waits until all of it has been read.
  std::vector<CapturedSubmessage> take();

 private:
  void run();
  void wait_for_own_mark();
  void parse(const std::uint8_t* packet, std::size_t size);
  void note(const std::uint8_t* message, std::size_t size, CapturedSubmessage common);
  int socket_;
  std::atomic<bool> stopping_{false};
  std::atomic<std::uint32_t> marks_seen_{0};
  std::uint32_t marks_sent_ = 0;
  std::mutex mutex_;
  std::vector<CapturedSubmessage> seen_;
  std::thread thread_;
};

}  // namespace tocsin
