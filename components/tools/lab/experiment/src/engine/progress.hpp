// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

namespace tocsin::experiment {

/// Tells how far an experiment is: one line that is rewritten on a terminal, else one line for
/// each tenth of the runs.
class Progress {
 public:
  /// `done` of `total` were there already.
  Progress(std::size_t total, std::size_t done, bool terminal);
  void advance();
  /// Ends the line on a terminal.
  void finish();

 private:
  void show();
  [[nodiscard]] double elapsed_s() const;
  std::size_t total_;
  std::size_t done_;
  std::size_t done_before_;
  bool terminal_;
  std::size_t shown_tenth_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// "1:05" or "1:02:03"; "-:--" when unknown (NaN, infinite).
[[nodiscard]] std::string clock_text(double s);

/// "  12 of 800 runs [##........]  1.5 %, 0:10, 1:05 left"; `rate` runs a second, 0 unknown.
[[nodiscard]] std::string progress_text(std::size_t done, std::size_t total, double elapsed_s,
                                        double rate);

}  // namespace tocsin::experiment
