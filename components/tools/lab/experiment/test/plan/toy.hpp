// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "foundation/error.hpp"
#include "foundation/temporary_folder.hpp"
#include "plan/plan.hpp"

namespace tocsin::experiment {

inline constexpr const char* toy_text =
    "duration_s: 100\n"
    "warm_up_s: 0\n"
    "observation_s: 10\n"
    "missions:\n"
    "  - {name: a, file: a.yaml, set: [navigator.speed_mps=0.1]}\n"
    "  - {name: b, file: b.yaml}\n"
    "channels:\n"
    "  - {name: near, file: \"near_${mission}.yaml\"}\n"
    "payloads:\n"
    "  - {name: camera, camera: true}\n"
    "  - {name: plain}\n"
    "policies:\n"
    "  - {name: none}\n"
    "  - {name: tocp_dsp, set: [alpha=3, network_monitor.window=10]}\n"
    "sets:\n"
    "  - {name: main, kind: thesis, title: The main set, payloads: [camera], seeds: 3}\n";

/// An experiment file with the files that it names.
class ToyExperiment : public TemporaryFolder {
 public:
  explicit ToyExperiment(const std::string& text = toy_text) {
    write("toy.yaml", text);
    for (const char* name : {"a.yaml", "b.yaml", "near_a.yaml", "near_b.yaml"})
      write(name, "x: 1\n");
  }
  [[nodiscard]] Experiment load() const { return load_experiment(path("toy.yaml")); }
};

/// The text of the ConfigError that `body` throws; "none" when it throws none.
template <class Body>
std::string error_of(Body body) {
  try {
    body();
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "none";
}

/// `text` with one part replaced.
inline std::string with(std::string text, const std::string& old, const std::string& fresh) {
  return text.replace(text.find(old), old.size(), fresh);
}

}  // namespace tocsin::experiment
