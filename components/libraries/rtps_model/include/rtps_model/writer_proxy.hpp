// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <vector>

#include "rtps_model/message.hpp"

namespace tocsin::rtps {

/// What a reliable reader knows of one writer: which of its samples are there, gone or missing
/// (Fast DDS: WriterProxy).
class WriterProxy {
 public:
  /// This sample and all before it are there, or will never come.
  [[nodiscard]] Sequence available() const { return available_; }
  [[nodiscard]] bool has(Sequence sequence) const {
    return sequence <= available_ || early_.count(sequence) != 0;
  }
  /// How many before this one are missing.
  [[nodiscard]] std::size_t missing_before(Sequence sequence) const;
  /// Those that are known to exist and are not there, the first 256 at most, in rising order.
  [[nodiscard]] std::vector<Sequence> missing() const;

  /// It is there, or will never come. False when that was known.
  bool settle(Sequence sequence);
  /// Of the writer's history: older samples will never come, all up to `last` exist.
  void on_history(Sequence first, Sequence last);

 private:
  void advance();
  Sequence available_ = 0;
  Sequence last_known_ = 0;
  std::set<Sequence> early_;  ///< settled ones after a missing one
};

}  // namespace tocsin::rtps
