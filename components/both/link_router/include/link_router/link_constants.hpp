// SPDX-License-Identifier: Apache-2.0
// What nobody needs to set of a router's decisions. Measured in test/bench/figures/link_router.md
// and experiment.md, unless a line says otherwise.
#pragma once

#include <chrono>
#include <cstddef>

#include "foundation/time.hpp"

namespace tocsin::router {

/// A sample of at least so many packets is bulk: it waits for the radio's queue, and the
/// capacity is measured on it.
inline constexpr std::size_t bulk_packets = 4;
/// What takes longer is counted as late.
inline constexpr Duration late_after = std::chrono::milliseconds(250);

/// From the first thing to report to the acknowledgement that reports it.
inline constexpr Duration acknowledgement_delay = std::chrono::milliseconds(20);
/// Between two acknowledgements, at least: when something came of a class whose repairs wait for
/// them, and else.
inline constexpr Duration acknowledgement_period = std::chrono::milliseconds(50);
inline constexpr Duration relaxed_period = std::chrono::milliseconds(100);
/// The former at most, where vehicles share air that is busy.
inline constexpr Duration acknowledgement_period_busy = std::chrono::milliseconds(200);
/// The same at most: when nothing is received.
inline constexpr Duration acknowledgement_idle = std::chrono::seconds(1);

/// The longest wait between two repairs: a link that is back is found within it. [s]
inline constexpr double repair_max_s = 0.5;
/// The longest wait for an acknowledgement that is expected of air which others share. [s]
inline constexpr double answer_max_s = 1;
/// Samples without a lifespan are repaired for so long; durable ones until they are superseded.
inline constexpr Duration repair_lifespan = std::chrono::seconds(5);

/// [B/s] capacity before anything was measured: what the lowest rate of 802.11, 1 Mbit/s, leaves.
inline constexpr double capacity_start_bytes_per_s = 100'000;
/// A peer that acknowledges nothing for so long, though something was sent, is silent.
inline constexpr Duration silent_after = std::chrono::milliseconds(600);
/// The same of a path, when there is another one that does answer.
inline constexpr Duration path_silent_after = std::chrono::milliseconds(250);
/// Of two paths, the one that nothing else goes by gets a small sample so often.
inline constexpr Duration path_probe_period = std::chrono::seconds(1);
/// Delays count from the least one of this time: longer than queues stand, shorter than clocks
/// drift by a millisecond.
inline constexpr Duration clock_window = std::chrono::seconds(30);

/// [B/s] what is assumed of the way while nobody else sends, before it was measured: of 6 Mbit/s,
/// the lowest rate of 802.11g.
inline constexpr double free_start_bytes_per_s = 500'000;
/// What a share of the air carries is learned anew so often: fading has come and gone.
inline constexpr Duration airtime_window = std::chrono::seconds(10);

/// [1] that are reckoned with on one channel, whatever is told.
inline constexpr unsigned most_vehicles = 100;

/// [1] of the capacity, for adaptive streams and all others together: the rest is room for repairs
/// and for a capacity that falls.
inline constexpr double utilisation = 0.5;
/// [s] time constants of the scale of adaptive streams: fast to fall, slow to rise.
inline constexpr double scale_fall_s = 0.5;
inline constexpr double scale_rise_s = 4;
/// [1] smaller changes of the scale are not reported.
inline constexpr double scale_step = 0.05;

/// [B] stored samples that go together, in one packet; a larger one goes alone.
inline constexpr std::size_t backfill_bytes = 1100;

}  // namespace tocsin::router
