// SPDX-License-Identifier: Apache-2.0
// What the link router's steps buy: the traffic and the drive of the thesis's missions, as the
// simulated components make them, over the thesis's radio with a router on each side.
// usage: link_router_bench [SEEDS [SECONDS]] [NAME=VALUE of LinkRouterParams ...]
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "link_run.hpp"
#include "mission_traffic.hpp"
#include "statistics.hpp"

namespace {

using namespace tocsin;
using namespace tocsin::bench;

struct Column {
  const char* name;
  double Figures::*value;
};
constexpr Column columns[] = {
    {"crit p50", &Figures::critical_p50_ms}, {"crit p99", &Figures::critical_p99_ms},
    {"high p50", &Figures::high_p50_ms},     {"high p99", &Figures::high_p99_ms},
    {"crit late%", &Figures::critical_late}, {"high late%", &Figures::high_late},
    {"crit lost%", &Figures::critical_lost}, {"high lost%", &Figures::high_lost},
    {"low dlv%", &Figures::low_delivered},   {"loc p99 s", &Figures::location_age_p99_s},
    {"pic p99", &Figures::picture_p99_ms},   {"pic/s", &Figures::pictures_per_s},
    {"pic kB", &Figures::picture_kb},        {"air%", &Figures::airtime},
    {"rcpt/s", &Figures::receipts_per_s},    {"rep/s", &Figures::repairs_per_s},
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
    std::vector<double> values;
    for (const Figures& run : runs) values.push_back(run.*column.value);
    std::printf(" %10.3g", mean_of(values).mean);
  }
  std::printf("\n");
  std::fflush(stdout);
}

struct Variant {
  const char* name;
  bool priority;
  bool adaptation;
  bool repair;
};
constexpr Variant variants[] = {
    {"nothing", false, false, false},           {"priority", true, false, false},
    {"adaptation", false, true, false},         {"repair", false, false, true},
    {"priority+adaptation", true, true, false}, {"all", true, true, true},
};

Steps steps_of(const Variant& variant, const router::LinkRouterParams& params) {
  Steps steps;
  steps.priority = variant.priority;
  steps.adaptation = variant.adaptation;
  steps.repair = variant.repair;
  steps.params = params;
  if (!variant.priority) {  // everything goes to the radio at once
    steps.params.bulk_backlog_s = 10;
    steps.params.bulk_under_way = 10000;
    steps.params.hold_backlog_s = 10;
  }
  return steps;
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<double> numbers;
  router::LinkRouterParams params;
  std::string only;
  bool trace = false;
  for (int i = 1; i < argc; ++i) {
    const char* equals = std::strchr(argv[i], '=');
    if (equals == nullptr) {
      numbers.push_back(std::atof(argv[i]));
      continue;
    }
    const std::string name(argv[i], static_cast<std::size_t>(equals - argv[i]));
    if (name == "only") {
      only = equals + 1;
      continue;
    }
    if (name == "trace") {
      trace = true;
      continue;
    }
    Setter setter{name, std::atof(equals + 1)};
    params.visit(setter);
    if (!setter.found) {
      std::fprintf(stderr, "no parameter %s\n", setter.name.c_str());
      return 2;
    }
  }
  const int seeds = !numbers.empty() ? static_cast<int>(numbers[0]) : 20;
  const double duration_s = numbers.size() > 1 ? numbers[1] : 600;
  print_head();
  for (int mission = 0; mission < 2; ++mission) {
    for (const bool pause : {false, true}) {
      std::map<std::string, std::vector<Figures>> results;
      for (int seed = 1; seed <= seeds; ++seed) {
        const auto traffic = record_mission(mission, pause ? "tocp_dsp" : "none", seed, duration_s);
        for (const Variant& variant : variants) {
          if (!only.empty() && only != variant.name) continue;
          Steps steps = steps_of(variant, params);
          steps.pause = pause;
          steps.trace = trace;
          results[variant.name].push_back(
              run_link(traffic, steps, static_cast<std::uint64_t>(seed)));
        }
      }
      for (const Variant& variant : variants) {
        if (results.count(variant.name) == 0) continue;
        print(std::string(mission == 0 ? "A" : "B") + (pause ? " tocp_dsp " : " none ") +
                  variant.name,
              results[variant.name]);
      }
    }
  }
  return 0;
}
