// SPDX-License-Identifier: Apache-2.0
// What the link router's steps buy: the traffic and the drive of the thesis's missions, as the
// simulated components make them, over the thesis's radio with a router on each side.
// usage: link_router_bench [SEEDS [SECONDS]] [only=VARIANT] [demo=1] [each=1]
//                          [CLASS=DSCP ...] [PARAMETER=VALUE ...]
// demo: the missions as bringup/demo plays them. each: a line for each seed, too.
// PARAMETER is one of LinkRouterParams. Mean of the seeds.
#include <cstdio>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "foundation/program.hpp"
#include "link_run.hpp"
#include "mission_traffic.hpp"

namespace {

using namespace tocsin;
using namespace tocsin::bench;

struct Column {
  const char* name;
  double Figures::*value;
};
constexpr Column columns[] = {
    {"crit p50", &Figures::critical_p50_ms},
    {"crit p99", &Figures::critical_p99_ms},
    {"high p50", &Figures::high_p50_ms},
    {"high p99", &Figures::high_p99_ms},
    {"crit late%", &Figures::critical_late},
    {"high late%", &Figures::high_late},
    {"crit lost%", &Figures::critical_lost},
    {"high lost%", &Figures::high_lost},
    {"low dlv%", &Figures::low_delivered},
    {"loc p99 s", &Figures::location_age_p99_s},
    {"pic p99", &Figures::picture_p99_ms},
    {"pic/s", &Figures::pictures_per_s},
    {"pic kB", &Figures::picture_kb},
    {"air%", &Figures::airtime},
    {"ack/s", &Figures::acknowledgements_per_s},
    {"ack B/s", &Figures::acknowledgement_bytes_per_s},
    {"rep/s", &Figures::repairs_per_s},
    {"unreach%", &Figures::unreachable},
    {"least p99", &Figures::least_p99_ms},
};

/// Sets the parameter that is named.
struct Setter {
  std::string name;
  double to;
  bool found = false;
  template <class Value, class Range>
  void set(const char* parameter, Value& value, const Range&) {
    if (name != parameter) return;
    value = static_cast<Value>(to);
    found = true;
  }
  void operator()(const char* parameter, double& value, std::pair<double, double> range,
                  const char*) {
    set(parameter, value, range);
  }
  void operator()(const char* parameter, int& value, std::pair<double, double> range, const char*) {
    set(parameter, value, range);
  }
};

void print_head() {
  std::printf("%-34s", "");
  for (const Column& column : columns) std::printf(" %10s", column.name);
  std::printf("\n");
}

void print(const std::string& name, const std::vector<Figures>& runs) {
  std::printf("%-34s", name.c_str());
  for (const Column& column : columns) {
    double sum = 0;
    for (const Figures& run : runs) sum += run.*column.value;
    std::printf(" %10.3g", sum / static_cast<double>(runs.size()));
  }
  std::printf("\n");
  std::fflush(stdout);
}

struct Variant {
  const char* name;
  bool priority;
  bool adaptation;
  bool repair;
  bool categories;
};
constexpr Variant variants[] = {
    {"nothing", false, false, false, false},
    {"priority", true, false, false, false},
    {"adaptation", false, true, false, false},
    {"repair", false, false, true, false},
    {"priority+adaptation", true, true, false, false},
    {"all", true, true, true, false},
    {"802.11e", false, false, false, true},
    {"802.11e priority", true, false, false, true},
    {"802.11e priority+adaptation", true, true, false, true},
    {"802.11e all", true, true, true, true},
};

struct Options {
  int seeds = 20;
  double duration_s = 600;
  std::string only;  ///< name of a variant; empty: all
  bool demo = false;
  bool each = false;
  router::LinkRouterParams params;
  DscpOfClass dscp;
};

/// Throws std::invalid_argument.
Options options_of(const std::vector<std::string>& words) {
  Options options;
  std::vector<double> numbers;
  for (const std::string& word : words) {
    const std::size_t equals = word.find('=');
    if (equals == std::string::npos) {
      numbers.push_back(std::stod(word));
      continue;
    }
    const std::string name = word.substr(0, equals);
    const std::string value = word.substr(equals + 1);
    if (name == "only") {
      options.only = value;
    } else if (name == "demo") {
      options.demo = value == "1";
    } else if (name == "each") {
      options.each = value == "1";
    } else if (const auto traffic_class = traffic_class_of(name)) {
      options.dscp.set(*traffic_class, static_cast<std::uint8_t>(std::stoi(value)));
    } else {
      Setter setter{name, std::stod(value)};
      options.params.visit(setter);
      if (!setter.found) throw std::invalid_argument(name + ": no such parameter");
    }
  }
  if (!numbers.empty()) options.seeds = static_cast<int>(numbers[0]);
  if (numbers.size() > 1) options.duration_s = numbers[1];
  return options;
}

Steps steps_of(const Variant& variant, const Options& options) {
  Steps steps;
  steps.adaptation = variant.adaptation;
  steps.repair = variant.repair;
  steps.categories = variant.categories;
  steps.params = options.params;
  steps.dscp = options.dscp;
  if (!variant.repair) steps.params.low_repairs = 0;
  if (!variant.priority) {  // everything goes to the radio at once
    steps.params.bulk_backlog_s = 10;
    steps.params.bulk_under_way = 10000;
    steps.params.hold_backlog_s = 10;
  }
  return steps;
}

void run_mission(const Options& options, bool b, const std::string& policy) {
  std::map<std::string, std::vector<Figures>> results;
  for (int seed = 1; seed <= options.seeds; ++seed) {
    const auto traffic = record_mission({b, options.demo, policy, seed, options.duration_s});
    for (const Variant& variant : variants) {
      if (!options.only.empty() && options.only != variant.name) continue;
      Steps steps = steps_of(variant, options);
      steps.pause = policy != "none";
      const auto radio_seed = static_cast<std::uint64_t>(seed);
      Figures figures = run_link(traffic, steps, radio_seed);
      add_bounds(traffic, steps, radio_seed, figures);
      results[variant.name].push_back(figures);
    }
  }
  for (const Variant& variant : variants) {
    if (results.count(variant.name) == 0) continue;
    const std::vector<Figures>& runs = results[variant.name];
    const std::string name = std::string(b ? "B " : "A ") + policy + ", " + variant.name;
    for (std::size_t i = 0; options.each && i < runs.size(); ++i) {
      print(name + ", seed " + std::to_string(i + 1), {runs[i]});
    }
    print(name, runs);
  }
}

}  // namespace

int main(int argc, char** argv) {
  return tocsin::run_program("link_router_bench", [&] {
    const Options options = options_of({argv + 1, argv + argc});
    print_head();
    for (const bool b : {false, true}) {
      for (const char* policy : {"none", "tocp_dsp"}) run_mission(options, b, policy);
    }
    return 0;
  });
}
