// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <random>
#include <vector>

#include "foundation/bytes.hpp"
#include "foundation/time.hpp"

namespace tocsin::kobuki {

struct LineParams {
  int usb_latency_ms = 1;
  int usb_packet_bytes = 62;
  double flip_probability = 0;
  double loss_probability = 0;
  double noise_probability = 0;
  template <class Visitor>
  void visit(Visitor& v) {
    v("usb_latency_ms", usb_latency_ms, {1, 16},
      "[ms] latency timer: 1 with the udev rule, else 16");
    v("usb_packet_bytes", usb_packet_bytes, {1, 62}, "[B] a packet is handed over when so full");
    v("flip_probability", flip_probability, {0, 1}, "[1] per byte: one bit is wrong");
    v("loss_probability", loss_probability, {0, 1}, "[1] per byte: it never arrives");
    v("noise_probability", noise_probability, {0, 1},
      "[1] per byte: a random byte comes before it");
  }
};

/// The way from the base to the computer: 115200 baud, then an FT232R that collects bytes into
/// packets. A packet is handed over when it is full or when the latency timer runs out.
/// Pure and seeded; `now` must not decrease.
class SerialLine {
 public:
  using Sink = std::function<void(ByteView packet)>;

  SerialLine(const LineParams& params, std::uint64_t seed, Time now);
  /// Faults and latency from now on.
  void configure(const LineParams& params) { params_ = params; }
  [[nodiscard]] const LineParams& params() const { return params_; }
  /// The base begins to send `bytes` at `now`, or when the line is free again.
  void send(ByteView bytes, Time now);
  /// Hands over every packet that is due.
  void deliver(Time now, const Sink& sink);
  /// Hands over everything that is on the way, in one piece; not before `last_delivery`.
  void deliver_all(Time now, const Sink& sink);
  /// When the next packet is due; `never` when nothing is on the way.
  [[nodiscard]] Time next_delivery() const;
  /// When all that is on the way is handed over, if nothing follows; may be earlier, never later.
  /// Who needs whole frames only calls `deliver` then.
  [[nodiscard]] Time last_delivery() const;
  /// Loses everything on the way.
  void clear();

 private:
  /// Bytes on the wire that follow each other without a pause.
  struct Run {
    Time begin;  ///< of the first bit of the first byte that is left
    std::size_t left;

    /// When the last bit of that byte of those left has come.
    [[nodiscard]] Time arrival(std::size_t of_left) const;
  };
  void put(ByteView bytes);
  /// Takes bytes of the first run into the packet, up to the next flush. At least one has come.
  void receive(Time now, const Sink& sink);
  void flush(const Sink& sink);
  [[nodiscard]] bool chance(double probability);
  [[nodiscard]] bool may_fill() const;
  [[nodiscard]] Duration latency() const {
    return std::chrono::milliseconds(params_.usb_latency_ms);
  }
  [[nodiscard]] std::size_t packet_size() const;
  [[nodiscard]] std::size_t on_wire() const { return bytes_.size() - packet_; }
  /// The first run-out of the latency timer at or after `at`.
  [[nodiscard]] Time timer_at_or_after(Time at) const;

  LineParams params_;
  std::mt19937_64 random_;
  std::deque<Run> wire_;             ///< none of them empty
  std::vector<std::uint8_t> bytes_;  ///< those in the packet, then those on the wire
  std::size_t packet_ = 0;           ///< how many are in the packet
  Time line_free_;
  Time timer_;  ///< next run-out of the latency timer
};

}  // namespace tocsin::kobuki
