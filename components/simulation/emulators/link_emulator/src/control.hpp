// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "radio_channel/channel_params.hpp"

namespace tocsin::link {

/// `pos X Y`, in metres in the map frame.
struct MoveTo {
  double x_m;
  double y_m;
};

/// `set outage SECONDS`: nothing is received from now on, (0, 86400] seconds.
struct BeginOutage {
  double length_s;
};

/// `set KEY VALUE` with a parameter of the channel file.
struct SetParameter {
  std::string key;
  std::string value;
};

/// What a datagram asks for; monostate when it is malformed.
using Command = std::variant<std::monostate, MoveTo, BeginOutage, SetParameter>;

[[nodiscard]] Command parse_command(const std::string& datagram);

/// Changes one parameter. False, and nothing changed, when the key is unknown or is a list, or the
/// value has the wrong type or lies outside its range.
[[nodiscard]] bool set_parameter(radio::ChannelParams& params, const SetParameter& command);

}  // namespace tocsin::link
