// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tocsin::router {

/// Everything that can be set of a router's decisions. Where the defaults come from: the what-if
/// study and `test/bench/link_router` (README, "Measured").
struct LinkRouterParams {
  int queue_bytes = 131072;
  double bulk_backlog_s = 0.01;
  int bulk_packets = 4;
  int bulk_under_way = 2;
  double hold_backlog_s = 0.25;
  double late_after_s = 0.25;
  double acknowledgement_delay_s = 0.02;
  double acknowledgement_period_s = 0.05;
  double acknowledgement_idle_s = 1.0;
  double repair_first_s = 0.07;
  double repair_backoff = 1.5;
  double repair_max_s = 0.5;
  double repair_share = 0.1;
  double repair_lifespan_s = 5;
  double capacity_start_bytes_per_s = 100000;
  double silence_s = 0.6;
  double clock_window_s = 30;
  double utilisation = 0.5;
  double scale_min = 0.25;
  double scale_fall_s = 0.5;
  double scale_rise_s = 4;
  double scale_step = 0.05;
  double backfill_share = 0.2;
  int backfill_bytes = 1100;

  template <class Visitor>
  void visit(Visitor& v) {
    visit_queue(v);
    visit_acknowledgements(v);
    visit_repair(v);
    visit_adaptation(v);
    visit_backfill(v);
  }

 private:
  template <class Visitor>
  void visit_backfill(Visitor& v) {
    v("backfill_share", backfill_share, {0.01, 1},
      "[1] of the capacity, for stored samples that did not cross at first, at most");
    v("backfill_bytes", backfill_bytes, {200, 65000},
      "[B] stored samples that go together; a larger one goes alone");
  }
  template <class Visitor>
  void visit_queue(Visitor& v) {
    v("queue_bytes", queue_bytes, {1024, 1e9},
      "[B] serialised samples of one class that may wait; beyond it the oldest goes");
    v("bulk_backlog_s", bulk_backlog_s, {0, 10},
      "[s] a sample of many packets waits while the radio's queue is longer");
    v("bulk_packets", bulk_packets, {1, 1000}, "[1] a sample of at least as many is bulk");
    v("bulk_under_way", bulk_under_way, {1, 10000},
      "[1] bulk samples of which no acknowledgement has told, at most");
    v("hold_backlog_s", hold_backlog_s, {0.01, 10},
      "[s] sources that follow the budget pause, and small samples of normal and low wait, while "
      "more than this is outstanding");
    v("late_after_s", late_after_s, {0.01, 10}, "[s] what takes longer is counted as late");
  }
  template <class Visitor>
  void visit_acknowledgements(Visitor& v) {
    v("acknowledgement_delay_s", acknowledgement_delay_s, {0, 1},
      "[s] from the first thing to tell to the acknowledgement that tells it");
    v("acknowledgement_period_s", acknowledgement_period_s, {0.01, 1},
      "[s] at least, between two acknowledgements");
    v("acknowledgement_idle_s", acknowledgement_idle_s, {0.1, 60},
      "[s] at most, also when nothing came");
  }
  template <class Visitor>
  void visit_repair(Visitor& v) {
    v("repair_first_s", repair_first_s, {0.005, 10},
      "[s] without an acknowledgement until the first repair; the expected wait in queues comes on "
      "top");
    v("repair_backoff", repair_backoff, {1, 10}, "[1] each further repair waits so much longer");
    v("repair_max_s", repair_max_s, {0.005, 60}, "[s] longest wait between two repairs");
    v("repair_share", repair_share, {0, 1}, "[1] of the capacity, for repairs at most");
    v("repair_lifespan_s", repair_lifespan_s, {0.1, 3600},
      "[s] samples without a lifespan are repaired for so long; durable ones until they are "
      "superseded");
  }
  template <class Visitor>
  void visit_adaptation(Visitor& v) {
    v("capacity_start_bytes_per_s", capacity_start_bytes_per_s, {1000, 1e9},
      "[B/s] capacity that is believed before anything was measured");
    v("silence_s", silence_s, {0.1, 60},
      "[s] a peer that acknowledges nothing for so long, though something was sent, is silent");
    v("clock_window_s", clock_window_s, {1, 3600},
      "[s] delays count from the least one seen in this time");
    v("utilisation", utilisation, {0.05, 1},
      "[1] of the capacity that adaptive streams and all others together shall take");
    v("scale_min", scale_min, {0.01, 1}, "[1] least scale of an adaptive stream");
    v("scale_fall_s", scale_fall_s, {0.01, 60}, "[s] time constant when the scale falls");
    v("scale_rise_s", scale_rise_s, {0.01, 60}, "[s] time constant when the scale rises");
    v("scale_step", scale_step, {0, 0.5}, "[1] smaller changes of the scale are not told");
  }
};

/// Rules across parameters. Throws ConfigError that names one; the constructors of LinkSender and
/// LinkReceiver call it.
void check(const LinkRouterParams& params);

}  // namespace tocsin::router
