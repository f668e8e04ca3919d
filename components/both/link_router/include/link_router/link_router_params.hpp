// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "link_router/link_constants.hpp"

namespace tocsin::router {

/// What can be set of a router's decisions; link_constants.hpp has the rest. Where the defaults
/// come from: test/bench/figures/link_router.md and experiment.md.
struct LinkRouterParams {
  int queue_bytes = 131072;
  double bulk_backlog_s = 0.01;
  int bulk_under_way = 1;
  double hold_backlog_s = 0.25;
  double repair_first_s = 0.07;
  double repair_backoff = 1.5;
  double repair_share = 0.1;
  int low_repairs = 2;
  double scale_min = 0.25;
  double backfill_share = 0.2;
  double second_bytes_per_s = 0;
  int vehicles = 1;

  template <class Visitor>
  void visit(Visitor& v) {
    v("queue_bytes", queue_bytes, {1024, 1e9},
      "[B] serialised samples of one class that may wait; beyond it the oldest goes");
    v("bulk_backlog_s", bulk_backlog_s, {0, 10},
      "[s] a sample of four or more packets waits while the radio's queue is longer");
    v("bulk_under_way", bulk_under_way, {1, 10000},
      "[1] such samples in pieces that are not acknowledged yet, at most; of whole ones one more");
    v("hold_backlog_s", hold_backlog_s, {0.01, 10},
      "[s] sources that follow the budget pause, and small samples of normal and low wait, while "
      "more than this is outstanding");
    v("repair_first_s", repair_first_s, {0.005, 0.5},
      "[s] without an acknowledgement until the first repair; the expected wait in queues comes on "
      "top");
    v("repair_backoff", repair_backoff, {1, 10},
      "[1] each further repair waits so much longer, up to 0.5 s");
    v("repair_share", repair_share, {0, 1}, "[1] of the capacity, for repairs at most");
    v("low_repairs", low_repairs, {0, 10},
      "[1] times that a packet of classes normal and low is sent again, when it is known to be "
      "lost");
    v("scale_min", scale_min, {0.01, 1}, "[1] least scale of an adaptive stream");
    v("backfill_share", backfill_share, {0.01, 1},
      "[1] of the capacity, for stored samples that did not cross at first, at most");
    v("second_bytes_per_s", second_bytes_per_s, {0, 1e9},
      "[B/s] of what waits for the radio, by a second path at most, whose use is metered; 0: what "
      "it carries");
    v("vehicles", vehicles, {1, most_vehicles},
      "[1] that share the air, this one included, until airtime_share says it; the bringup file's "
      "count, where it has several");
  }
};

/// Throws ConfigError when `hold_backlog_s` is below `bulk_backlog_s`.
void check(const LinkRouterParams& params);

}  // namespace tocsin::router
