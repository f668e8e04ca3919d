// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sstream>

#include "metrics/toy_recording.hpp"
#include "plan/toy.hpp"
#include "results/result_store.hpp"

namespace tocsin::experiment {

/// The folder of a finished toy experiment: 2 missions, policies none and tocp_dsp, 3 runs each.
/// The probe PER of tocp_dsp is 20 points lower in every run, its QNI the same.
class ToyResults : public ToyExperiment {
 public:
  explicit ToyResults(const std::string& text = toy_text) : ToyExperiment(text) {
    std::string settings = "build: 0.1.0+toy\nexperiment: |\n";
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) settings += "  " + line + "\n";
    const auto plan = make_plan(load());
    const ResultStore store(folder(), "series");
    store.open(settings);
    for (const Run& run : plan) store.write(run, result_of(run));
    store.write_table(plan);
  }
  [[nodiscard]] std::string folder() const { return path("out"); }
  /// Adds real runs: QNI one point higher than simulated, the first one not done.
  void add_real() const {
    const auto plan = make_plan(load());
    const ResultStore store(folder(), "real");
    std::filesystem::create_directories(folder() + "/real");
    for (const Run& run : plan) {
      RunResult result = result_of(run);
      result.measures.values[index_of(Metric::qni_mean)] += 1;
      if (run.number == 0) result.measures.values[index_of(Metric::completed)] = 0;
      store.write(run, result);
    }
    store.write_table(plan);
  }

 private:
  static RunResult result_of(const Run& run) {
    auto recording = toy_recording();
    for (auto& quality : recording.qualities) {
      const double worse = run.policy.name == "none" ? 20 : 0;
      quality.per_percent += quality.per_percent > 0 ? worse + run.index : 0;
    }
    return {"", 100, measure(recording, toy_timing())};
  }
};

}  // namespace tocsin::experiment
