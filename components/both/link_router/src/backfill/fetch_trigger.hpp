// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "foundation/time.hpp"
#include "runtime/middleware/traffic_rules.hpp"
#include "runtime/port.hpp"

namespace tocsin {

/// Waits for the events that a rule of the list `fetch` names.
class FetchTrigger {
 public:
  /// Throws ConfigError with the rule's name when no installed package knows its topic, or the
  /// topic has no such field.
  FetchTrigger(Component& owner, const FetchRule& rule);

  [[nodiscard]] const FetchRule& rule() const { return rule_; }
  /// When an event began since the last call: a sample that fulfils the rule, `min_interval_s`
  /// after the last one that did, and of a rule with a field after one that did not.
  [[nodiscard]] std::optional<Time> take();
  /// An event of an earlier instance goes on.
  void resume(Time now) { last_ = now; }

 private:
  [[nodiscard]] bool holds(const void* message) const;
  const FetchRule rule_;
  const TypeInfo& type_;
  InputPort input_;
  std::optional<Time> last_;  ///< sample that fulfilled it
  bool holds_ = false;        ///< the rule, by the last sample
};

/// Of these rules. Throws like FetchTrigger.
[[nodiscard]] std::vector<std::unique_ptr<FetchTrigger>> make_triggers(
    Component& owner, const std::vector<FetchRule>& rules);

}  // namespace tocsin
