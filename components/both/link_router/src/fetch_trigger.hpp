// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "field_condition.hpp"
#include "runtime/port.hpp"

namespace tocsin {

/// Waits for what a rule of the list `fetch` names.
class FetchTrigger {
 public:
  /// Throws ConfigError with the rule's name when nobody here knows its topic, or the topic has no
  /// such field.
  FetchTrigger(Component& owner, const FetchRule& rule);

  [[nodiscard]] const FetchRule& rule() const { return rule_; }
  /// When an event began that was not told yet: a sample that fulfils the rule, so long after the
  /// last one that did as the rule says, and of a rule with a field after one that did not.
  [[nodiscard]] std::optional<Time> take();
  /// An event of an earlier life goes on: it was told.
  void resume(Time now) { last_ = now; }

 private:
  const FetchRule rule_;
  InputPort input_;
  FieldCondition condition_;
  std::optional<Time> last_;  ///< sample that fulfilled it
  bool holds_ = false;        ///< the condition, by the last sample
};

/// The rule that `fetch_around_stop_s` stands for.
[[nodiscard]] FetchRule around_stop(double s);
/// Of these rules, and of a stop when `around_stop_s` is above 0. Throws like FetchTrigger.
[[nodiscard]] std::vector<std::unique_ptr<FetchTrigger>> make_triggers(
    Component& owner, const std::vector<FetchRule>& rules, double around_stop_s);

}  // namespace tocsin
