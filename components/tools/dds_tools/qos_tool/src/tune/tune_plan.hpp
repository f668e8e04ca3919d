// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <utility>
#include <vector>

namespace tocsin::qos_tool {

/// One setting that a sweep changes, by the word that stands in the file:
/// `qos.PROFILE.POLICY`, `class.ROLE.TOPIC`, or `COMPONENT.KEY` as of `tocsin launch --set`.
struct SweptSetting {
  std::string key;
  std::vector<std::string> values;  ///< as YAML writes them
};

/// What `tocsin qos tune FILE` is to try: an experiment file (tocsin experiment) without `policies`
/// and `sets`, and in their place
struct TunePlan {
  struct Params {
    std::string policy = "none";
    std::string qos;
    std::string traffic;
    int seeds = 20;
    template <class Visitor>
    void visit(Visitor& v) {
      v("policy", policy, "policy of the transmission controller, the same for all");
      v("qos", qos, "QoS file, relative to this one, that the sweep starts from; empty: shipped");
      v("traffic", traffic, "traffic file that it starts from; empty: the shipped one");
      v("seeds", seeds, {2, 1000}, "[1] simulated runs of each candidate, mission and channel");
    }
  };
  std::string path;       ///< of the file
  YAML::Node experiment;  ///< the rest of it, its files as absolute paths
  Params params;          ///< files as absolute paths
  std::vector<SweptSetting> sweep;
};

/// One way to set everything that is swept.
struct Candidate {
  std::string name;                                           ///< "shipped", "c1", "c2", ...
  std::vector<std::pair<std::string, std::string>> settings;  ///< key and value; shipped: none
};

/// `shipped_config`: folder of the files that an empty `qos` or `traffic` stands for. Throws
/// ConfigError naming file, line, key, value and what is allowed.
[[nodiscard]] TunePlan read_tune_plan(const std::string& path, const std::string& shipped_config);

/// What there is now, and every combination of the values, the last setting innermost. Throws
/// ConfigError when there are more than 200.
[[nodiscard]] std::vector<Candidate> candidates_of(const TunePlan& plan);

/// "qos.stream.lifespan_s=0.5 class.uxv.location=critical"; of the shipped one "as shipped".
[[nodiscard]] std::string settings_text(const Candidate& candidate);

/// The candidate's QoS and traffic file; empty when it leaves them as they are. The second throws
/// ConfigError when the traffic file has no such topic for the role.
[[nodiscard]] std::string qos_text(const TunePlan& plan, const Candidate& candidate);
[[nodiscard]] std::string traffic_text(const TunePlan& plan, const Candidate& candidate);

/// Runs of the candidates as an experiment file, which names `NAME.qos.yaml` and
/// `NAME.traffic.yaml` beside it where there are such texts.
[[nodiscard]] std::string experiment_text(const TunePlan& plan,
                                          const std::vector<Candidate>& candidates);

}  // namespace tocsin::qos_tool
