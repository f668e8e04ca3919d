// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "foundation/time.hpp"
#include "radio_channel/channel_params.hpp"
#include "radio_channel/random.hpp"

namespace tocsin::radio {

/// Loss without a MAC: independent (Bernoulli), or with a probability that follows a two-state
/// Markov process in time (Gilbert 1960, Elliott 1963). Both directions share the state, whose
/// course depends on the seed alone and not on the traffic.
class PacketLoss {
 public:
  PacketLoss(const ChannelParams& params, std::uint64_t seed, Time start);
  /// Whether a packet at `now` is lost. `now` must not decrease.
  [[nodiscard]] bool lost(Time now);

 private:
  [[nodiscard]] bool bad(Time now);

  ChannelParams params_;
  RandomStream packets_;
  RandomStream states_;
  bool bad_ = false;
  Time change_at_;
};

}  // namespace tocsin::radio
