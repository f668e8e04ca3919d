// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "deployment/deployment.hpp"
#include "geometry/wall.hpp"
#include "radio_channel/channel_params.hpp"
#include "radio_channel/propagation.hpp"

namespace tocsin::check {

/// What the emulated radio carries where it is poor.
struct PoorPlace {
  std::string channel;     ///< its file
  double mean_snr_db = 0;  ///< of the place
  double bytes_per_s = 0;  ///< IP bytes that come through when packets never cease
  double loss = 0;         ///< [0,1] of these packets on the air
};

/// At the place within the walls that a tenth of all places are worse than, though no place below
/// 8 dB, where little comes through however little is sent. Deterministic; takes milliseconds.
[[nodiscard]] PoorPlace poor_place(radio::ChannelParams params,
                                   const std::vector<geometry::Wall>& walls);

/// The same for the radio of a deployment; empty without one, and for one that is no model of a
/// place (modes without MAC, a recorded trace). Throws ConfigError for a bad file.
[[nodiscard]] std::optional<PoorPlace> poor_place_of(const deployment::Deployment& deployment);

}  // namespace tocsin::check
