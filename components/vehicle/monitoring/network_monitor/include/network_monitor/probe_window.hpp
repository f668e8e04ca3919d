// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "foundation/parameters.hpp"
#include "foundation/time.hpp"

namespace tocsin::network {

/// How the link is probed. Defaults: the thesis's setting, 20 packets every 0.3 s.
struct ProbeParams {
  double period_s = 0.3;
  double timeout_s = 1.0;
  int window = 20;
  double sample_period_s = 1.0;

  template <class Visitor>
  void visit(Visitor& v) {
    v("period_s", period_s, {0.02, 10}, "[s] time between two echo requests");
    live(v)("timeout_s", timeout_s, {0.02, 10}, "[s] a reply that takes longer is a lost probe");
    live(v)("window", window, {1, 1000}, "[1] newest settled probes that make a sample");
    v("sample_period_s", sample_period_s, {0.1, 60}, "[s] time between two samples");
  }
};

/// Round-trip times of the answered probes of a window.
struct RttSummary {
  double min_ms = 0;
  double mean_ms = 0;
  double max_ms = 0;
};

/// The link over the newest settled probes: those sent longer ago than the timeout. Younger ones
/// are in no count, not even when answered: to count answers at once and losses after the timeout
/// would make the link look better than it is.
struct ProbeSample {
  double per_percent = 0;         ///< [%] [0, 100] share of `sent` without a reply in time
  int sent = 0;                   ///< settled probes looked at, 1 to `window`
  int received = 0;               ///< of these, answered in time
  std::optional<RttSummary> rtt;  ///< empty when none was answered
};

/// Counted since the start; never reset.
struct ProbeTotals {
  std::uint64_t duplicates = 0;   ///< second replies to one probe; ignored
  std::uint64_t late = 0;         ///< replies beyond the timeout; the probe stays lost
  std::uint64_t unknown = 0;      ///< replies to a probe that has left the memory, or never was
  std::uint64_t send_errors = 0;  ///< probes that the kernel refused; they count as lost
};

enum class ReplyKind { accepted, duplicate, late, unknown };

/// Decides when to probe, and what the replies say about the link.
///
/// Pure: no socket, no clock. `now` must not decrease between calls. The first call starts it.
class ProbeWindow {
 public:
  explicit ProbeWindow(const ProbeParams& params);
  /// Another timeout and window from now on. A probe whose reply was late stays lost.
  void set_limits(const ProbeParams& params);

  /// What was sent so far no longer counts, as if it had not been sent. Sequence numbers go on.
  void forget();

  /// The sequence number of a probe to send at `now`, at most one per call. Slots that were missed
  /// (the process was frozen) are skipped, not sent in a burst.
  [[nodiscard]] std::optional<std::uint16_t> take_due(Time now);

  /// Corrects the send time of a probe from `take_due` to the instant it really left.
  void on_sent(std::uint16_t sequence, Time at);
  /// The kernel refused the probe: it is lost, whatever arrives.
  void on_send_error(std::uint16_t sequence);

  /// A reply that arrived at `received_at` (kernel stamp; may lie before the last `now`). What
  /// counts is the time of arrival, not the time of reading. A reply before its probe has RTT 0.
  ReplyKind on_reply(std::uint16_t sequence, Time received_at);

  /// A sample when one is due at `now`. Empty as well while no probe has settled. A link without
  /// any reply in the window is a sample with PER 100.
  [[nodiscard]] std::optional<ProbeSample> take_sample(Time now);

  /// When to call `take_due` and `take_sample` next. In the past before the first call.
  [[nodiscard]] Time next_deadline() const;

  [[nodiscard]] const ProbeTotals& totals() const { return totals_; }

 private:
  struct Probe {
    Time sent;
    std::optional<Duration> rtt;
    bool refused = false;
  };

  void start(Time now);
  [[nodiscard]] Probe* find(std::uint16_t sequence);
  [[nodiscard]] bool is_settled(const Probe& probe, Time now) const;
  [[nodiscard]] std::optional<ProbeSample> summarize(Time now) const;

  Duration period_;
  Duration sample_period_;
  Duration timeout_{};
  std::size_t window_ = 0;
  std::size_t memory_ = 0;  ///< probes remembered: the window and all that may be on their way
  bool started_ = false;
  Time next_probe_ = Time::min();
  Time next_sample_ = Time::min();
  std::uint16_t first_sequence_ = 0;  ///< of probes_.front()
  std::deque<Probe> probes_;
  ProbeTotals totals_;
};

}  // namespace tocsin::network
