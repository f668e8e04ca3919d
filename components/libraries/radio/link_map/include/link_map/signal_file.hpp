// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "link_map/link_map.hpp"

namespace tocsin::link_map {

/// Reads positions with signal, a line each, in the order of the drive: columns apart by commas,
/// semicolons or spaces, named in the first line. `columns`: "x,y,signal", the names to take;
/// empty: those that are usual (x_m, pose_x, robot_pos_x, ...; rssi_dbm, signal_dbm, ...). Lines
/// may have more columns than the first one names. Cells of these columns that are empty or `nan`,
/// and signals outside of [-120, 0] dBm, which cards use for "not measured", are left out. A column
/// loss_percent need not be there.
///
/// Throws ConfigError naming `name`, line, column, text and what is allowed.
[[nodiscard]] std::vector<Reading> signals_in(std::string_view text, const std::string& name,
                                              const std::string& columns);

/// The same as `signals_in` reads: the columns x_m, y_m, signal_dbm, loss_percent.
[[nodiscard]] std::string signal_text(const std::vector<Reading>& readings);

}  // namespace tocsin::link_map
