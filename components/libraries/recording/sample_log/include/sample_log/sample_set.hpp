// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <utility>

#include "sample_log/sample_id.hpp"
#include "sample_log/sequence_set.hpp"

namespace tocsin::sample_log {

/// Samples of many writers, in bounded memory: beyond 4096 writers the one unheard of for longest
/// is forgotten, beyond 4096 gaps of a writer the lowest counts as closed.
class SampleSet {
 public:
  using Writer = std::pair<std::uint64_t, std::uint64_t>;  ///< stream and source

  [[nodiscard]] bool contains(const SampleId& id) const;
  /// Whether it was not in it yet.
  bool add(const SampleId& id);
  void add(const Writer& writer, std::uint64_t first, std::uint64_t last);

  struct Known {
    SequenceSet sequences;
    std::uint64_t used = 0;  ///< rises with each use of any
  };
  [[nodiscard]] const std::map<Writer, Known>& writers() const { return writers_; }

 private:
  Known& known(const Writer& writer);
  std::map<Writer, Known> writers_;
  std::uint64_t uses_ = 0;
};

}  // namespace tocsin::sample_log
