// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "idl_support/type_info.hpp"
#include "runtime/middleware/fetch_rule.hpp"

namespace tocsin {

/// What a rule asks of the messages of a type.
class FieldCondition {
 public:
  /// Throws ConfigError with the rule's name when the type has no such field outside of lists, or
  /// when the field cannot be compared so. `type` must outlive it.
  FieldCondition(const TypeInfo& type, const FetchRule& rule);

  /// Of a message of the type. What is NaN is neither above, nor below, nor equal.
  [[nodiscard]] bool holds(const void* message) const;

 private:
  const TypeInfo& type_;
  const FetchRule rule_;
  double number_ = 0;  ///< of equal, for a field that is a number
};

}  // namespace tocsin
