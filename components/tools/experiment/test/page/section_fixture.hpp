// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <string>

#include "page/sections.hpp"

namespace tocsin::experiment {

/// Results of one set with these groups; values by metric.
class SectionTest : public ::testing::Test {
 protected:
  SectionTest() {
    RunSet set;
    set.name = "main";
    set.kind = "comparison";
    set.title = "The main set";
    results_.experiment.sets = {set};
  }
  /// The kind of the set that all groups are of.
  void kind(const std::string& kind) { results_.experiment.sets[0].kind = kind; }
  Group& add(const std::string& policy, const std::string& payload = "camera",
             const std::string& mission = "a") {
    Group group;
    group.set = "main";
    group.mission = mission;
    group.channel = "near";
    group.payload = payload;
    group.policy = policy;
    for (int i = 1; i <= 5; ++i) {
      group.indices.push_back(i);
      group.values.emplace_back(metric_count, std::nan(""));
      group.series.emplace_back();
    }
    results_.groups.push_back(group);
    return results_.groups.back();
  }
  static void set(Group& group, Metric metric, double first) {
    double value = first;
    for (auto& run : group.values) run[index_of(metric)] = value += 0.01;
  }
  /// Five runs of one observation each for every value.
  static void series(Group& group, double Observation::*part,
                     std::initializer_list<double> values) {
    for (auto& run : group.series) {
      run.assign(values.size(), Observation{0, NAN, NAN, NAN, 1, 0, 0, 0, NAN, false});
      auto one = run.begin();
      for (const double value : values) (*one++).*part = value;
    }
  }
  /// Both policies, with the highest PER and the p99 latency of each.
  void pair(double none_per, double dsp_per, double none_ms, double dsp_ms) {
    Group& none = add("none");
    set(none, Metric::telemetry_per_max, none_per);
    set(none, Metric::high_latency_p99, none_ms);
    Group& dsp = add("tocp_dsp");
    set(dsp, Metric::telemetry_per_max, dsp_per);
    set(dsp, Metric::high_latency_p99, dsp_ms);
  }
  template <class Add>
  std::string text(Add add_section) {
    Document document;
    add_section(results_, document);
    figures_.clear();
    scripts_.clear();
    for (const Figure& figure : document.figures()) {
      figures_ += figure.title() + "\n";
      scripts_ += figure.script();
    }
    return document.text();
  }
  Results results_;
  std::string figures_;  ///< their titles
  std::string scripts_;  ///< what draws them
};

}  // namespace tocsin::experiment
