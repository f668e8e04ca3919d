// SPDX-License-Identifier: Apache-2.0
#include "radio_channel/ofdm.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace tocsin::radio {
namespace {

enum class CodeRate { half, two_thirds, three_quarters };

struct Rate {
  double mbps;
  int bits_per_symbol;  // data bits of one 4 us symbol
  int bits_per_carrier;
  CodeRate code;
};

constexpr std::array<Rate, rate_count> rates{{{6, 24, 1, CodeRate::half},
                                              {9, 36, 1, CodeRate::three_quarters},
                                              {12, 48, 2, CodeRate::half},
                                              {18, 72, 2, CodeRate::three_quarters},
                                              {24, 96, 4, CodeRate::half},
                                              {36, 144, 4, CodeRate::three_quarters},
                                              {48, 192, 6, CodeRate::two_thirds},
                                              {54, 216, 6, CodeRate::three_quarters}}};

const Rate& rate_of(int rate) {
  assert(rate >= 0 && rate < rate_count);
  return rates[static_cast<std::size_t>(rate)];
}

/// Error probability of a coded bit before decoding.
double raw_bit_error(int bits_per_carrier, double snr) {
  switch (bits_per_carrier) {
    case 1:
      return 0.5 * std::erfc(std::sqrt(snr));
    case 2:
      return 0.5 * std::erfc(std::sqrt(snr / 2));
    case 4:
      return 0.75 * 0.5 * std::erfc(std::sqrt(snr / 10));
    default:
      return 7.0 / 12.0 * 0.5 * std::erfc(std::sqrt(snr / 42));
  }
}

/// Sum of weights times powers of d, the first power `first`, then in steps of `step`.
template <std::size_t count>
double weight_sum(const std::array<double, count>& weights, double d, int first, int step) {
  double sum = 0;
  int power = first;
  for (const double weight : weights) {
    sum += weight * std::pow(d, power);
    power += step;
  }
  return sum;
}

/// Union bound of the industry-standard code (133, 171); weights as in the NIST report.
double decoded_bit_error(CodeRate code, double p) {
  static constexpr std::array<double, 10> half{36,     211,     1404,     11633,     77433,
                                               502690, 3322763, 21292910, 134365911, 0};
  static constexpr std::array<double, 10> two_thirds{3,     70,     285,    1276,    6160,
                                                     27128, 117019, 498860, 2103891, 8784123};
  static constexpr std::array<double, 10> three_quarters{
      42, 201, 1492, 10469, 62935, 379644, 2253373, 13073811, 75152755, 428005675};
  const double d = std::sqrt(4 * p * (1 - p));
  switch (code) {
    case CodeRate::half:
      return weight_sum(half, d, 10, 2) / 2;
    case CodeRate::two_thirds:
      return weight_sum(two_thirds, d, 6, 1) / 4;
    default:
      return weight_sum(three_quarters, d, 5, 1) / 6;
  }
}

double log_bit_success(int rate, double snr_db) {
  const Rate& r = rate_of(rate);
  const double p = raw_bit_error(r.bits_per_carrier, std::pow(10, snr_db / 10));
  return std::log1p(-std::min(decoded_bit_error(r.code, p), 1 - 1e-12));
}

double error_of(double log_success) {
  return log_success > -1e-9 ? -log_success : 1 - std::exp(log_success);
}

constexpr double table_from_db = -10;
constexpr double table_to_db = 40;
constexpr double steps_per_db = 20;

}  // namespace

double rate_mbps(int rate) { return rate_of(rate).mbps; }

int ack_rate(int rate) { return rate >= 4 ? 4 : rate >= 2 ? 2 : 0; }

Duration frame_duration(int rate, int bytes) {
  const int per_symbol = rate_of(rate).bits_per_symbol;
  const int symbols = (16 + 8 * bytes + 6 + per_symbol - 1) / per_symbol;
  return std::chrono::microseconds{20 + 4 * symbols + 6};
}

double frame_error_probability(int rate, double snr_db, int bytes) {
  return -std::expm1(8.0 * bytes * log_bit_success(rate, snr_db));
}

FrameErrorTable::FrameErrorTable() {
  constexpr int steps = static_cast<int>((table_to_db - table_from_db) * steps_per_db);
  for (int rate = 0; rate < rate_count; ++rate) {
    for (int i = 0; i <= steps; ++i) {
      log_bit_success_[rate].push_back(log_bit_success(rate, table_from_db + i / steps_per_db));
    }
  }
}

/// Within the table only.
double FrameErrorTable::log_success(int rate, double snr_db, int bytes) const {
  const auto& table = log_bit_success_[rate];
  const double place = (snr_db - table_from_db) * steps_per_db;
  const auto i = static_cast<std::size_t>(place);
  const double part = place - static_cast<double>(i);
  return 8.0 * bytes * (table[i] + part * (table[i + 1] - table[i]));
}

double FrameErrorTable::error(int rate, double snr_db, int bytes) const {
  if (!(snr_db > table_from_db)) return 1;
  if (snr_db >= table_to_db) return 0;
  return error_of(log_success(rate, snr_db, bytes));
}

bool FrameErrorTable::lost(int rate, double snr_db, int bytes, double draw) const {
  if (!(snr_db > table_from_db)) return true;
  if (snr_db >= table_to_db) return false;
  const double log = log_success(rate, snr_db, bytes);
  return draw < -log && draw < error_of(log);  // 1 - exp(x) is never above -x
}

const FrameErrorTable& frame_errors() {
  static const FrameErrorTable table;
  return table;
}

double snr_for_error_db(int rate, int bytes, double probability) {
  double low = table_from_db;
  double high = table_to_db;
  while (high - low > 1e-6) {
    const double middle = (low + high) / 2;
    (frame_error_probability(rate, middle, bytes) > probability ? low : high) = middle;
  }
  return high;
}

}  // namespace tocsin::radio
