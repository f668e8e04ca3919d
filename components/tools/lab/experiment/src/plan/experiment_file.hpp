// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <vector>

#include "foundation/enum_words.hpp"
#include "foundation/parameters.hpp"
#include "plan/fitted_file.hpp"

namespace tocsin::experiment {

/// A mission, and what has to be set for it.
struct Mission {
  std::string name;
  std::string file;
  std::vector<std::string> set;  ///< "component.key=value", as of `tocsin launch`
  template <class Visitor>
  void visit(Visitor& v) {
    v("name", name, "word that names it in results");
    v("file", file, "mission file, relative to the experiment file; required");
    v("set", set, "component.key=value, as of tocsin launch");
  }
};

/// A radio; ${mission} in the path stands for the mission's name.
struct Channel {
  std::string name;
  std::string file;
  std::string seeds_of;  ///< empty: its own
  template <class Visitor>
  void visit(Visitor& v) {
    v("name", name, "word that names it in results");
    v("file", file, "channel file, relative to the experiment file; ${mission} is replaced");
    v("seeds_of", seeds_of, "channel whose seeds it shares, to be paired with; empty: its own");
  }
};

/// What the vehicle sends besides its telemetry.
struct Payload {
  std::string name;
  bool camera = false;
  std::vector<std::string> set;
  template <class Visitor>
  void visit(Visitor& v) {
    v("name", name, "word that names it in results");
    v("camera", camera, "whether the vehicle has a camera");
    v("set", set, "component.key=value, as of tocsin launch");
  }
};

/// A way to decide.
struct PolicyChoice {
  std::string name;
  std::string policy;            ///< of the decision library; empty: as `name`
  std::vector<std::string> set;  ///< "key=value" of the controller, or "component.key=value"
  std::string qos;               ///< QoS file; empty: the bringup's
  std::string traffic;           ///< traffic file; empty: the bringup's
  template <class Visitor>
  void visit(Visitor& v) {
    v("qos", qos, "QoS file, relative to this one; empty: the bringup's");
    v("traffic", traffic, "traffic file, relative to this one; empty: the bringup's");
    v("name", name, "word that names it in results");
    v("policy", policy, "policy of the decision library; empty: as name");
    v("set", set, "key=value of the transmission controller, or component.key=value");
  }
};

/// What runs are for.
enum class SetKind { thesis, comparison, sensitivity, real, fit };
inline constexpr auto words_of(SetKind) {
  return std::array{"thesis", "comparison", "sensitivity", "real", "fit"};
}

/// Runs that belong together: every mission with every channel, payload, policy and seed.
struct RunSet {
  std::string name;
  SetKind kind = SetKind::comparison;
  std::string title;
  std::vector<std::string> missions;
  std::vector<std::string> channels;
  std::vector<std::string> payloads;
  std::vector<std::string> policies;
  int first_seed = 1;
  int seeds = 1;
  template <class Visitor>
  void visit(Visitor& v) {
    v("name", name, "word that names it in results");
    visit_enum(v, "kind", kind, Choices{"thesis", "comparison", "sensitivity", "real", "fit"},
               "its place in the report; fit: runs that parameters are fitted to");
    v("title", title, "heading in the report");
    v("missions", missions, "names; empty: all");
    v("channels", channels, "names; empty: all");
    v("payloads", payloads, "names; empty: all");
    v("policies", policies, "names; empty: all");
    v("first_seed", first_seed, {1, 1000000}, "[1] number of the first run");
    v("seeds", seeds, {1, 100000}, "[1] runs of each combination");
  }
};

/// Weights of the one cost by which runs are judged. Its unit is one percent of class low that is
/// not delivered; README.md gives the reason of each.
struct CostWeights {
  double critical_late = 10;
  double critical_very_late = 20;
  double high_late = 4;
  double high_very_late = 8;
  double low_undelivered = 1;
  double location_age = 20;
  double picture_latency = 5;
  double airtime = 0.1;
  template <class Visitor>
  void visit(Visitor& v) {
    v("critical_late", critical_late, {0, 1e6}, "[1/%] later than 250 ms or lost, critical");
    v("critical_very_late", critical_very_late, {0, 1e6}, "[1/%] more when later than 1 s or lost");
    v("high_late", high_late, {0, 1e6}, "[1/%] later than 250 ms or lost, class high");
    v("high_very_late", high_very_late, {0, 1e6}, "[1/%] more when later than 1 s or lost");
    v("low_undelivered", low_undelivered, {0, 1e6}, "[1/%] of class low that never came");
    v("location_age", location_age, {0, 1e6}, "[1/s] 99th percentile of the age of the location");
    v("picture_latency", picture_latency, {0, 1e6}, "[1/s] 99th percentile of pictures");
    v("airtime", airtime, {0, 1e6}, "[1/%] share of the time that we are on the air");
  }
};

/// What holds for every run.
struct Timing {
  std::string bringup = "mission.yaml";
  std::vector<std::string> without{"gcs/view"};
  double duration_s = 600;
  double warm_up_s = 10;
  double observation_s = 6;
  double poor_below_snr_db = 10;
  int vehicles = 1;
  std::string fitted;
  int fits = 1;
  CostWeights cost;  ///< the file's map `cost`
  template <class Visitor>
  void visit(Visitor& v) {
    v("bringup", bringup, "bringup file; a bare name is looked for in the share");
    v("without", without, "host/process that is left out");
    v("duration_s", duration_s, {10, 86400}, "[s] a run ends here or with its mission");
    v("warm_up_s", warm_up_s, {0, 3600}, "[s] not counted, at the start");
    v("observation_s", observation_s, {1, 600}, "[s] one observation of figures and windows");
    v("poor_below_snr_db", poor_below_snr_db, {-20, 60},
      "[dB] the link is truly poor while its mean SNR is below");
    v("vehicles", vehicles, {1, 1000}, "[1] vehicles of a run; must be 1, as of a bringup file");
    v("fitted", fitted, "file of tocsin experiment fit, relative to this one; empty: none");
    v("fits", fits, {1, 20},
      "[1] fits of the parameters, each to seeds of its own; runs take them in turn");
  }
};

/// A whole experiment file; names resolved, paths absolute.
struct Experiment {
  std::string file;
  Fitted fitted;  ///< as load_experiment read it; empty without a file
  Timing timing;
  std::vector<Mission> missions;
  std::vector<Channel> channels;
  std::vector<Payload> payloads;
  std::vector<PolicyChoice> policies;
  std::vector<RunSet> sets;
};

/// Throws ConfigError with file, line, key, value and what is allowed.
[[nodiscard]] Experiment load_experiment(const std::string& path);

/// The same before there is a file of fitted parameters: `timing.fitted` names it, `fitted` is
/// empty.
[[nodiscard]] Experiment load_unfitted(const std::string& path);

/// The same of a text that was read from `path`; the files that it names need not be there.
[[nodiscard]] Experiment parse_experiment(const std::string& text, const std::string& path);

}  // namespace tocsin::experiment
