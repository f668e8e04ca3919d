// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/fast_dds/names.hpp"

namespace tocsin {

/// Whom a link is to, where that is said: of a station that serves several vehicles the one.
/// Nothing is taken of any other participant. Thread-safe.
class ExpectedPeers {
 public:
  using Participant = eprosima::fastdds::rtps::GuidPrefix_t;
  /// Of the first so many strange names each is refused once, and `refused_before` from then on, as
  /// are all others: who invents names fills no log.
  static constexpr std::size_t most_told = 32;
  enum class Judgement { expected, refused, refused_before };

  /// Names of their hosts; empty: whoever comes.
  explicit ExpectedPeers(std::vector<std::string> names) : names_(std::move(names)) {}

  /// `name`: of its host, proven on a secured link.
  [[nodiscard]] Judgement judge(const Participant& participant, const std::string& name) {
    if (takes(name)) return Judgement::expected;
    const std::lock_guard<std::mutex> lock(mutex_);
    refused_.insert(participant);
    const bool is_new = told_.size() < most_told && told_.insert(name).second;
    return is_new ? Judgement::refused : Judgement::refused_before;
  }
  [[nodiscard]] bool takes(const std::string& name) const {
    return names_.empty() || std::find(names_.begin(), names_.end(), name) != names_.end();
  }
  /// `subject` of a certificate, as RFC 2253 has it: `CN=/uxv1`.
  [[nodiscard]] bool takes_subject(const std::string& subject) const {
    constexpr std::string_view start = "CN=/";
    return names_.empty() ||
           (subject.compare(0, start.size(), start) == 0 && takes(subject.substr(start.size())));
  }
  [[nodiscard]] bool is_refused(const Participant& participant) const {
    if (names_.empty()) return false;
    const std::lock_guard<std::mutex> lock(mutex_);
    return refused_.count(participant) != 0;
  }
  /// Whether it was refused.
  bool forget(const Participant& participant) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return refused_.erase(participant) != 0;
  }
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

 private:
  const std::vector<std::string> names_;
  mutable std::mutex mutex_;
  std::set<Participant> refused_;
  std::set<std::string> told_;
};

}  // namespace tocsin
