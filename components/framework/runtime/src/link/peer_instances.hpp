// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "foundation/time.hpp"

namespace tocsin {

/// Which instance of each peer counts. A peer has a name and one instance at a time; a restart has
/// another one.
///
/// An announcement and a departure are hints, traffic is evidence. The first of a name counts at
/// once. Another one is a candidate. It takes over when it is received from and the one that counts
/// is silent for four of its usual gaps, 0.2 to 1.5 s, or was never received from. One that was
/// displaced and is received from all the same, for 0.3 s, was not killed: it takes over at once,
/// and who displaced it must then wait for a silence of 2 s. Pure; `now` never decreases.
class PeerInstances {
 public:
  using Id = std::uint64_t;
  /// What changes: who counts from now on, and who does no longer.
  struct Change {
    std::optional<Id> joined;
    std::optional<Id> left;
  };
  static constexpr Duration least_silence = std::chrono::milliseconds(200);
  static constexpr Duration most_silence = std::chrono::milliseconds(1500);
  static constexpr Duration silence_for_the_refuted = std::chrono::seconds(2);
  static constexpr Duration returned_for = std::chrono::milliseconds(300);

  /// Discovery has found it. Again changes nothing.
  [[nodiscard]] Change on_announced(Id id, const std::string& name, Time now);
  /// Discovery has forgotten it, so that nothing more of it is received until it is found again.
  [[nodiscard]] Change on_departed(Id id, Time now);
  /// A sample of it was received.
  [[nodiscard]] Change on_received(Id id, Time now);
  /// None of these names counts from now on, whatever is received; another set replaces it. Of a
  /// name that is in it no more, the instance counts that was announced last.
  [[nodiscard]] std::vector<Change> set_absent(const std::set<std::string>& names);
  [[nodiscard]] bool counts(Id id) const;
  /// Empty for one that is not known.
  [[nodiscard]] std::string name_of(Id id) const;

 private:
  struct Instance {
    std::string name;
    std::uint64_t order = 0;  ///< in which they were announced
    std::optional<Time> heard{};
    Duration gap{0};                  ///< between samples, smoothed
    std::optional<Time> displaced{};  ///< by another one, since then
    std::optional<Time> returned{};   ///< received from again since then
    bool refuted = false;             ///< it has displaced one that went on
  };
  static void hear(Instance& instance, Time now);
  [[nodiscard]] static bool may_take_over(Instance& candidate, const Instance& current, Time now);
  [[nodiscard]] Change replace(Id current, Id by, Time now);
  /// The one of a name that was announced last.
  [[nodiscard]] std::optional<Id> last_of(const std::string& name) const;

  std::map<Id, Instance> instances_;
  std::map<std::string, Id> current_;
  std::set<std::string> absent_;
  std::uint64_t announced_ = 0;
};

}  // namespace tocsin
