// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "terminal/line.hpp"
#include "tocsin_idl/tocsin_msgs.hpp"

/// What a host's router tells of the link, for the terminals that show it.
namespace tocsin::link_text {

/// The way that the sender of a role feeds: `Uplink` from the vehicle, `Downlink` from the ground
/// station; `Link` for another word than those of roles.
[[nodiscard]] std::string direction(const std::string& role);

/// The state in one line, what matters most first: peers that are silent, a closed gate, capacity,
/// backlog, loss, late and repaired samples of class critical + high, scale of the adaptive
/// streams, and, of all bytes since the router started, the shares of repairs, acknowledgements,
/// backfill, the emergency stop's value and discovery. `-` for what is no number;
/// a capacity that is only assumed is `not measured`.
/// The words that matter less give way where there is no room (terminal::Span::rank).
[[nodiscard]] terminal::Line words(const tocsin_msgs::msg::LinkState& state);

/// The same for a log: `uplink 180 kB/s, loss 3 %`.
[[nodiscard]] std::string summary(const tocsin_msgs::msg::LinkState& state);

/// What each way has carried since its router started: a table with a row for each class of which
/// the host has offered something, its head first, at most `width` columns wide. Empty without
/// states.
[[nodiscard]] std::vector<terminal::Line> table(
    const std::vector<tocsin_msgs::msg::LinkState>& states, std::size_t width);

}  // namespace tocsin::link_text
