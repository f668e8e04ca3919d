// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

namespace tocsin::radio {

/// A fast, reproducible stream of random numbers: the same (seed, stream) gives the same numbers on
/// every machine, which std::uniform_real_distribution does not promise.
///
/// Generator: xoshiro256++ (Blackman and Vigna 2019), seeded by splitmix64.
class RandomStream {
 public:
  /// Streams of one seed are independent of each other.
  RandomStream(std::uint64_t seed, std::uint64_t stream) {
    std::uint64_t x = seed ^ (stream * 0xd1342543de82ef95u);
    for (auto& word : state_) word = splitmix(x);
  }

  [[nodiscard]] std::uint64_t bits() {
    const std::uint64_t result = rotate(state_[0] + state_[3], 23) + state_[0];
    const std::uint64_t t = state_[1] << 17;
    state_[2] ^= state_[0];
    state_[3] ^= state_[1];
    state_[1] ^= state_[2];
    state_[0] ^= state_[3];
    state_[2] ^= t;
    state_[3] = rotate(state_[3], 45);
    return result;
  }

  /// In [0, 1).
  [[nodiscard]] double uniform() { return static_cast<double>(bits() >> 11) * 0x1.0p-53; }

  /// True with probability `p`; never when p <= 0, always when p >= 1.
  [[nodiscard]] bool chance(double p) { return uniform() < p; }

  /// In [0, n), n > 0. The bias below 2^-32 is ignored.
  [[nodiscard]] int below(int n) {
    return static_cast<int>(((bits() >> 32) * static_cast<std::uint64_t>(n)) >> 32);
  }

  [[nodiscard]] double exponential(double mean) { return -mean * std::log1p(-uniform()); }

  /// Counts of a Poisson law, `mean` at most a few dozen.
  [[nodiscard]] int poisson(double mean) {
    double product = uniform();
    if (product <= 1 - mean) return 0;  // exp(-mean) is not below that; saves the exponential
    const double limit = std::exp(-mean);
    int count = 0;
    for (; product > limit; product *= uniform()) ++count;
    return count;
  }

 private:
  static std::uint64_t rotate(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }

  static std::uint64_t splitmix(std::uint64_t& x) {
    std::uint64_t z = (x += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  std::uint64_t state_[4];
};

}  // namespace tocsin::radio
