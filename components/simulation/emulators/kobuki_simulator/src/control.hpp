// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "simulated_base.hpp"

namespace tocsin::kobuki {

/// Obeys one line of the control channel and returns the answer: "ok", "error: ..." or, for `get`,
/// the state as one JSON object.
///
///     get
///     set KEY=VALUE ...   buttons bumper cliff wheel_drop over_current digital (masks as on the
///                         wire), analog0 to analog3, dock_right dock_centre dock_left,
///                         charger=none|adapter|dock, charge=0..1, slip=0..1, usb_latency_ms
///                         usb_packet_bytes flip loss noise
///     place X Y YAW       [m] [m] [rad]
///     version HW FW [old] answers to version requests from now on, "old" in 2 bytes
///     gains P I D         of the wheel controllers, as if the user had set them
///     silence SECONDS     no bytes for a time
///     unplug [SECONDS]    pulls the cable, for ever without a time
///     plug                puts it back
///     laser VERB          unplug, plug, stall, free, cover (its left half), uncover, stick
///     (repeats
///                         its last turn), loosen; of the simulator, for its laser
///     reset               switches the base off and on
///
/// A `set` with one bad entry changes nothing.
[[nodiscard]] std::string obey_control(SimulatedBase& base, const std::string& line, Time now);

}  // namespace tocsin::kobuki
