// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>

namespace tocsin {

/// Whether a name is a pattern: `*` stands in it for any text, slashes included, `?` for any
/// character, `[ab]` for one of several (POSIX fnmatch).
[[nodiscard]] bool is_pattern(const std::string& name);
[[nodiscard]] bool fits(const std::string& pattern, const std::string& name);

/// What is said of topics or services by name. A name counts before every pattern, a longer pattern
/// before a shorter one, and of two as long the first in the alphabet.
template <class Rule>
class NameRules {
 public:
  /// False: the name, or the same pattern, has a rule already.
  bool add(const std::string& name, const Rule& rule) {
    return (is_pattern(name) ? patterns_ : names_).insert({name, rule}).second;
  }
  /// Null: none fits.
  [[nodiscard]] const Rule* find(const std::string& name) const {
    const auto named = names_.find(name);
    if (named != names_.end()) return &named->second;
    const typename std::map<std::string, Rule>::value_type* found = nullptr;
    for (const auto& one : patterns_) {
      const bool longer = found == nullptr || one.first.size() > found->first.size();
      if (longer && fits(one.first, name)) found = &one;
    }
    return found == nullptr ? nullptr : &found->second;
  }
  /// Without patterns.
  [[nodiscard]] const std::map<std::string, Rule>& names() const { return names_; }
  [[nodiscard]] const std::map<std::string, Rule>& patterns() const { return patterns_; }

 private:
  std::map<std::string, Rule> names_;
  std::map<std::string, Rule> patterns_;
};

}  // namespace tocsin
