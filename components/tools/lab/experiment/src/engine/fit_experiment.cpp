// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "engine/run_experiment.hpp"
#include "fit/fit_policies.hpp"
#include "foundation/error.hpp"
#include "results/result_store.hpp"

namespace tocsin::experiment {
namespace {

/// The runs of kind fit by mission and number of the fit; failed ones are left out.
std::map<std::string, std::vector<Trace>> read_traces(const Experiment& experiment,
                                                      const std::string& folder) {
  const ResultStore store(folder, "fit");
  std::map<std::string, std::vector<Trace>> traces;
  for (const Run& run : make_plan(experiment)) {
    const auto result = store.read(run);
    if (!result || !result->failure.empty()) continue;
    if (run.policy.policy != "none") {
      throw ConfigError("sets." + run.set + ".policies: '" + run.policy.name +
                        "': parameters are fitted to runs without a policy, must be none");
    }
    const int fit = fit_of(run.index, experiment.timing.fits);
    traces[fitted_key(run.mission.name, fit)].push_back(trace_of(result->measures.series));
  }
  return traces;
}

/// For people, and the comment of the file.
std::string table(const std::string& mission, const MissionFit& fit, std::size_t runs) {
  char line[200];
  std::snprintf(line, sizeof line, "mission %s, %zu runs without a policy:\n", mission.c_str(),
                runs);
  std::string text = line;
  for (const Tuned& one : fit.policies) {
    std::string settings;
    for (const std::string& setting : one.settings) settings += " " + setting;
    std::snprintf(line, sizeof line, "  %-12s %6.1f %s\n", one.policy.c_str(), one.regret,
                  settings.c_str());
    text += line;
  }
  return text;
}

}  // namespace

int fit_experiment(const RunOptions& options) {
  const Experiment experiment = load_unfitted(options.file);
  const std::string& path = experiment.timing.fitted;
  if (path.empty()) {
    throw ConfigError(options.file + ": experiment.fitted: names no file to write to");
  }
  const int code = run_experiment(options);
  if (code != 0) return code;
  Fitted fitted;
  std::string tables;
  for (const auto& [mission, traces] : read_traces(experiment, options.out)) {
    const MissionFit fit = fit_policies(traces, mission);
    fitted[mission] = settings_of(fit);
    tables += table(mission, fit, traces.size());
  }
  const std::string name = std::filesystem::path(options.file).filename();
  try {
    write_whole(path, fitted_text(fitted, "Written by `tocsin experiment fit " + name +
                                              "`. Cost over the clairvoyant's per 1000 samples, "
                                              "decided again on these runs:\n" +
                                              tables));
  } catch (const std::system_error& error) {
    throw EnvironmentError(path + ": " + error.code().message());
  }
  std::printf("%s%s\n", tables.c_str(), path.c_str());
  return 0;
}

}  // namespace tocsin::experiment
