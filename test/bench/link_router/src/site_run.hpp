// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <vector>

#include "airtime_allocator/airtime_allocator.hpp"
#include "router_radio.hpp"

namespace tocsin::bench {

/// How the air of a site is divided.
enum class Division {
  none,
  equal_bytes,  ///< the rival: so that all send the same, in as much of the air
  airtime,
};

/// One run of a site: vehicles that all send what is urgent, and bulk. Most stand near the access
/// point and send bulk without end; the last one, if there is any, is elsewhere.
struct SiteRun {
  std::size_t near = 1;
  bool last = true;
  Division division = Division::none;
  AirtimeAllocator::Params shares = {};
  bool access_categories = false;
  double length_s = 60;
  std::uint64_t seed = 1;
  /// [m] Where the last one is at a time since the begin of the run.
  std::function<double(double)> last_x_m = [](double) { return 200; };
  /// [1/s] Pictures that the last one takes and keeps until they have gone; 0: bulk without end.
  double last_pictures_per_s = 0;
  /// Whether it may send them at a time since the begin of the run.
  std::function<bool(double)> last_may_send = [](double) { return true; };
};

/// What became of a vehicle's samples, after the first ten seconds and before the last one.
struct SiteCounts {
  double critical = 0;  ///< offered, both ways
  double in_time = 0;   ///< of these, delivered within 250 ms
  std::vector<double> critical_ms;
  double bulk_bytes = 0;  ///< delivered
};

/// Of each vehicle, the last one last.
[[nodiscard]] std::vector<SiteCounts> run_site(const SiteRun& run);

/// Of the vehicles near.
struct SiteFigures {
  double p50_ms = 0;
  double p99_ms = 0;
  double late = 0;           ///< [%] of critical samples, lost ones too
  double near_kb_per_s = 0;  ///< of bulk, each
  double last_kb_per_s = 0;  ///< of bulk, of the last one
};
[[nodiscard]] SiteFigures figures_of(const SiteRun& run);

}  // namespace tocsin::bench
