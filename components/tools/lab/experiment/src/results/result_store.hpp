// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plan/plan.hpp"
#include "results/run_result.hpp"

namespace tocsin::experiment {

/// The results of an experiment on disk: `settings.yaml`, `runs.csv`, `series/<run>.csv`.
///
/// A run's file appears whole or not at all, so that an experiment can be interrupted anywhere.
class ResultStore {
 public:
  /// `kind` is "series", or "real" for runs of the real stack.
  ResultStore(std::string folder, std::string kind);

  /// Makes the folder, or goes on in one that was begun with the same settings; drafts of killed
  /// runs are removed. With `other_build` the line `build:` may differ; the old one is then kept
  /// under `earlier_builds:`. Throws ConfigError when it holds another experiment or, without that,
  /// was begun by another build; EnvironmentError when it cannot be written.
  void open(const std::string& settings, bool other_build = false) const;
  /// The result of a run; empty when it is not finished, or its file is damaged.
  [[nodiscard]] std::optional<RunResult> read(const Run& run) const;
  /// Throws std::system_error when the disk does not take it.
  void write(const Run& run, const RunResult& result) const;
  /// Rows of all finished runs in the order of the plan: runs.csv or real.csv.
  void write_table(const std::vector<Run>& plan) const;
  [[nodiscard]] std::string table_path() const;
  void remove_drafts() const;

 private:
  [[nodiscard]] std::string path(const Run& run) const;
  [[nodiscard]] std::string merged(const std::string& old, const std::string& settings,
                                   bool other_build) const;
  std::string folder_;
  std::string kind_;
};

/// Writes a file whole or not at all. Throws std::system_error.
void write_whole(const std::string& path, const std::string& text);

/// The file of one run, and back. Numbers have six digits.
[[nodiscard]] std::string to_text(const RunResult& result);
[[nodiscard]] std::optional<RunResult> parse_result(const std::string& text);

}  // namespace tocsin::experiment
