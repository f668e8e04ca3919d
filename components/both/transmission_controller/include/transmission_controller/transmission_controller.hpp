// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "decision/policy.hpp"
#include "decision/qni.hpp"
#include "foundation/time.hpp"

namespace tocsin {

/// A decision for one role and what it rests on.
struct TransmissionDecision {
  decision::Evidence evidence;
  unsigned changes = 0;  ///< changes of state since start
  double quality_age_s;  ///< [s] age of the last measurement; NaN before the first
};

/// Turns measurements of the network, and their absence, into decisions.
///
/// A measurement that stays away for longer than `quality_timeout_s` is a sample of its own, once
/// each timeout: QNI 0 when `silence_is_poor` (the ground station: no report came through the
/// link), otherwise "no measurement" (the vehicle: its own monitor failed, which says nothing
/// about the link). The index is rounded to the precision of the message that publishes it, so that
/// `tocsin decide` decides a recording exactly as the run did. Pure; one thread.
class TransmissionController {
 public:
  struct Params {
    decision::PolicyParams policy;
    decision::QniParams quality;
    double quality_timeout_s = 3.0;
    bool silence_is_poor = false;

    template <class Visitor>
    void visit(Visitor& v) {
      policy.visit(v);
      quality.visit(v);
      v("quality_timeout_s", quality_timeout_s, {0.1, 600},
        "[s] network quality that is older counts as absent");
      v("silence_is_poor", silence_is_poor,
        "absent network quality counts as a dead link (QNI 0), not as unknown");
    }
  };

  /// Throws ConfigError when parameters contradict each other.
  explicit TransmissionController(const Params& params);

  /// A measurement that was received at `now`.
  TransmissionDecision on_quality(const decision::QniInput& measured, Time now);
  /// To be called at deadline(): a decision when silence or the end of a pause asks for one.
  std::optional<TransmissionDecision> on_time(Time now);
  [[nodiscard]] Time deadline() const;
  /// What lies ahead, for the decisions until the next call.
  void foresee(const decision::Outlook& outlook) { policy_->foresee(outlook); }
  [[nodiscard]] const char* policy_name() const { return policy_->name(); }

 private:
  TransmissionDecision conclude(const decision::Evidence& evidence, Time now);

  decision::QniModel index_;
  std::unique_ptr<decision::Policy> policy_;
  Duration timeout_;
  bool silence_is_poor_;
  std::optional<Time> heard_;
  Time silent_at_ = never;
  Time pause_ends_ = never;
  unsigned changes_ = 0;
};

}  // namespace tocsin
