// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "foundation/time.hpp"

namespace tocsin::radio {

/// The eight rates of 802.11g (ERP-OFDM, 20 MHz): 6, 9, 12, 18, 24, 36, 48, 54 Mbit/s.
inline constexpr int rate_count = 8;

/// Bytes that the MAC adds to an IP packet: header 24, LLC/SNAP 8, CCMP 8, check sequence 4.
inline constexpr int mac_overhead_bytes = 44;
inline constexpr int ack_bytes = 14;

/// Timing of 802.11g with short slots (IEEE 802.11-2016, table 18-5).
inline constexpr Duration slot_time{9'000};
inline constexpr Duration sifs{10'000};
inline constexpr Duration difs{28'000};
inline constexpr int cw_min = 15;
inline constexpr int cw_max = 1023;

[[nodiscard]] double rate_mbps(int rate);

/// The rate of the acknowledgement: the highest of 6, 12, 24 Mbit/s not above `rate`.
[[nodiscard]] int ack_rate(int rate);

/// Time on the air of a frame of `bytes` with MAC header: preamble and signal field 20 us, symbols
/// of 4 us over 16 service, the data and 6 tail bits, and the signal extension of 6 us.
[[nodiscard]] Duration frame_duration(int rate, int bytes);

/// Probability that a frame of `bytes` is received wrongly at `snr_db`: the NIST model (Pei and
/// Henderson, "Validation of OFDM error rate model in ns-3", 2010): AWGN, hard decision, union
/// bound of the convolutional code.
[[nodiscard]] double frame_error_probability(int rate, double snr_db, int bytes);

/// The same from a table with steps of 0.05 dB from -10 to 40 dB, which costs one exp(). Outside
/// the table the ends hold: always wrong, never wrong.
class FrameErrorTable {
 public:
  FrameErrorTable();
  [[nodiscard]] double error(int rate, double snr_db, int bytes) const;
  /// Whether `draw`, uniform in [0, 1), is below that: the frame is lost. Seldom costs the exp().
  [[nodiscard]] bool lost(int rate, double snr_db, int bytes, double draw) const;

 private:
  [[nodiscard]] double log_success(int rate, double snr_db, int bytes) const;

  std::vector<double> log_bit_success_[rate_count];
};

/// The table, made at the first call.
[[nodiscard]] const FrameErrorTable& frame_errors();

/// The SNR at which a frame of `bytes` at `rate` is lost with `probability`.
[[nodiscard]] double snr_for_error_db(int rate, int bytes, double probability);

}  // namespace tocsin::radio
