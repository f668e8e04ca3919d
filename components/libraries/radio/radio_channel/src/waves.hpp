// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace tocsin::radio {

/// x minus the nearest integer, |x| < 2^51.
[[nodiscard]] inline double fraction_of_turn(double x) {
  constexpr double round = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to an integer
  return x - ((x + round) - round);
}

/// cos(2 pi x), |x| < 2^51, error below 1e-7. Without branches and calls, so that loops over many
/// waves vectorise; std::cos would dominate the cost of the channel.
[[nodiscard]] inline double cos_turns(double x) {
  const double turn = fraction_of_turn(x);
  const double z = turn * turn;  // |turn| <= 0.5; Chebyshev fit of cos(2 pi turn) in turn^2
  return 1.0 +
         z * (-19.739208802178716 +
              z * (64.93939402266829 +
                   z * (-85.45681720669373 +
                        z * (60.24464137187666 +
                             z * (-26.42625678337438 +
                                  z * (7.903536371318467 +
                                       z * (-1.714390711088672 +
                                            z * (0.28200596845579 + z * -0.0363828411425456))))))));
}

/// Four numbers in one register.
inline constexpr std::size_t lane_count = 4;
using Lanes [[gnu::vector_size(lane_count * sizeof(float))]] = float;

/// cos(2 pi x), |x| <= 0.5, error below 2e-6.
[[nodiscard]] inline Lanes fast_cos_turns(Lanes x) {
  const Lanes z = x * x;
  return 0.9999992f +
         z * (-19.73898f + z * (64.92859f + z * (-85.27084f + z * (58.78694f + z * -21.06543f))));
}

/// sin(2 pi x), |x| <= 0.5, error below 2e-6.
[[nodiscard]] inline Lanes fast_sin_turns(Lanes x) {
  const Lanes z = x * x;
  return x *
         (6.283185f +
          z * (-41.34159f + z * (81.59991f + z * (-76.61414f + z * (41.34137f + z * -12.46882f)))));
}

}  // namespace tocsin::radio
