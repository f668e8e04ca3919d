// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "decision/outlook.hpp"
#include "decision/policy_params.hpp"
#include "foundation/enum_words.hpp"
#include "foundation/time.hpp"

namespace tocsin::decision {

/// Whether the gated writers may speak.
enum class State { active, passive };

/// Why the state is what it is after a call.
enum class Reason {
  start,             ///< nothing was decided yet; active
  steady,            ///< nothing spoke for a change
  no_measurement,    ///< the sample was not finite
  stale_sample,      ///< the sample is older than one taken before; used as no measurement
  threshold_low,     ///< quality fell below the lower bound
  threshold_high,    ///< quality rose to the upper bound
  cusum_alarm,       ///< the CUSUM for "turned bad" reached its threshold
  detector_alarm,    ///< another detector of "turned bad" reached its threshold
  reverse_alarm,     ///< the CUSUM for "turned good" reached its threshold
  best_so_far,       ///< the best sample of the pause came at or after candidate r*
  belief_bad,        ///< the network is probably bad: silence pays
  belief_good,       ///< the network is probably good again
  legacy_drop,       ///< one sample looked bad to the thesis's source
  legacy_count,      ///< the thesis's source had counted to 30
  foreseen,          ///< the clairvoyant knew
  better_ahead,      ///< a place with a better link comes on the way, soon enough
  good_enough,       ///< waiting for a better place on the way costs more than sending here
  no_outlook,        ///< nothing can be foreseen: no plan, no map, or what is measured is not it
  fixed_pause_over,  ///< the pause of fixed length ended
  forced_resume_samples,  ///< the pause reached th_max_samples
  forced_resume_time,     ///< the pause reached th_max_s
};

/// The words for messages and tables, equal to the enumerators.
inline constexpr auto words_of(Reason) {
  return std::array{"start",
                    "steady",
                    "no_measurement",
                    "stale_sample",
                    "threshold_low",
                    "threshold_high",
                    "cusum_alarm",
                    "detector_alarm",
                    "reverse_alarm",
                    "best_so_far",
                    "belief_bad",
                    "belief_good",
                    "legacy_drop",
                    "legacy_count",
                    "foreseen",
                    "better_ahead",
                    "good_enough",
                    "no_outlook",
                    "fixed_pause_over",
                    "forced_resume_samples",
                    "forced_resume_time"};
}
[[nodiscard]] inline const char* to_string(Reason reason) { return word_of(reason); }
[[nodiscard]] inline const char* to_string(State state) {
  return state == State::active ? "active" : "passive";
}

/// One measurement of the network.
struct Sample {
  Time stamp;  ///< when it was measured, on the clock of `now`
  double qni;  ///< [0,100]; NaN when nothing could be measured
};

/// A decision and what it rests on; published and recorded with every sample.
struct Evidence {
  State state = State::active;
  bool changed = false;  ///< whether this call changed the state
  Reason reason = Reason::start;
  double sample = std::numeric_limits<double>::quiet_NaN();  ///< QNI used; NaN when none
  double statistic = 0;  ///< what the policy compares, before a reset that its alarm causes
  double threshold = 0;  ///< what it is compared to
  int age = 0;           ///< samples since the pause began, this one included; 0 while active
  std::optional<Time> deadline;  ///< when silence ends at the latest; empty while active
};

/// What a rule says about one sample.
struct Decision {
  bool change = false;
  Reason reason = Reason::steady;
  double statistic = 0;
  double threshold = 0;
};

/// The part in which policies differ. Policy owns time, gaps and the limit of silence.
class Rule {
 public:
  virtual ~Rule() = default;
  /// One sample while active; NaN when none. `change` asks for a pause.
  virtual Decision while_active(double qni) = 0;
  /// Sample `age` (1, 2, ...) of a pause; NaN when none. `change` asks to resume.
  virtual Decision while_passive(double qni, int age) = 0;
  /// The state has become `state`, asked for or forced.
  virtual void entered(State state) = 0;
  /// Nothing was heard for so long while active that earlier evidence is void.
  virtual void forget() = 0;
  /// What lies ahead, until it is called again; most rules do not look.
  virtual void foresee(const Outlook&) {}
};

/// Decides when the gated writers fall silent and when they speak again.
///
/// Promises, whatever the samples and the clock do: a pause ends at the latest with its sample
/// number th_max_samples and, given a call at the deadline, after th_max_s of clock time; NaN and
/// stale samples are never evidence; a clock that goes back never prolongs a pause by more than
/// was still left. No throw, no allocation.
class Policy {
 public:
  /// Throws ConfigError when the limits contradict each other. `name` must outlive the policy.
  Policy(const char* name, const PolicyLimits& limits, std::unique_ptr<Rule> rule);

  /// Takes one sample, in the order of arrival. The answer holds from now until the next call.
  Evidence on_sample(const Sample& sample, Time now);
  /// What lies ahead from now on, for the samples until the next call.
  void foresee(const Outlook& outlook) { rule_->foresee(outlook); }
  /// Ends a pause that has lasted th_max_s even if samples stopped. Harmless at any other time.
  Evidence on_deadline(Time now);

  [[nodiscard]] State state() const { return state_; }
  [[nodiscard]] const char* name() const { return name_; }

 private:
  bool advance(Time now);
  bool is_stale(Time stamp, bool clock_went_back);
  [[nodiscard]] bool pause_expired() const;
  void limit_silence(Decision& decision) const;
  Evidence conclude(const Decision& decision, double qni);

  const char* name_;
  int th_max_samples_;
  Duration th_max_;
  Duration gap_;
  std::unique_ptr<Rule> rule_;
  State state_ = State::active;
  int age_ = 0;
  Duration silent_{};
  std::optional<Time> now_;
  std::optional<Time> last_stamp_;
  Duration unheard_{};
};

/// The policy that `params` names; with a wanted run length or policy belief this takes some tenths
/// of a second, because thresholds are computed. Throws ConfigError when a rule across fields is
/// broken.
[[nodiscard]] std::unique_ptr<Policy> make_policy(const PolicyParams& params);

}  // namespace tocsin::decision
