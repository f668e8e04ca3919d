// SPDX-License-Identifier: Apache-2.0
#include "access_point.hpp"

#include "deployment/deployment.hpp"
#include "foundation/error.hpp"
#include "radio_channel/channel_files.hpp"

namespace tocsin::foxglove {

std::optional<geometry::Point> access_point_of(const std::string& run_dir) {
  if (run_dir.empty()) return std::nullopt;
  try {
    const auto radio = deployment::load_resolved(run_dir + "/deployment.yaml").radio;
    if (!radio) return std::nullopt;
    const radio::ChannelParams channel = radio::load_channel(radio->channel);
    if (channel.mode != "radio") return std::nullopt;
    return geometry::Point{channel.access_point_x_m, channel.access_point_y_m};
  } catch (const ConfigError&) {
    return std::nullopt;  // the page only lacks a mark
  }
}

}  // namespace tocsin::foxglove
