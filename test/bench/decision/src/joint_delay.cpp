// SPDX-License-Identifier: Apache-2.0
// Which quality index finds a link that turns bad the fastest, at equal rates of false alarms: the
// thesis's, the channel's, or the joint one of all readings.
// usage: joint_delay [SAMPLES [RUNS]]
//   SAMPLES between false alarms [1000], RUNS falls for each delay [200]
// A vehicle circles the access point of the radio model, probes it as network_monitor does and
// sends a picture's packets beside. Laws and the joint index are fitted to drives on a good link
// and on two bad ones (10 dB weaker; a channel that others keep 80 % busy), thresholds are taken
// from other good drives. Then the link falls after 120 s; a fall that is not found in 200 s counts
// as 200.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "decision/joint_fit.hpp"
#include "decision/link_model.hpp"
#include "decision/quality_index.hpp"
#include "probing_vehicle.hpp"
#include "recording.hpp"

namespace tocsin::decision {
namespace {

const std::vector<Fall> falls{{"4 dB weaker", 4, usual_load},   {"8 dB weaker", 8, usual_load},
                              {"14 dB weaker", 14, usual_load}, {"channel 60 % busy", 0, 0.6},
                              {"channel 85 % busy", 0, 0.85},   {"4 dB, 60 % busy", 4, 0.6}};

using Measurements = std::vector<QualityMeasurement>;

/// Seconds 60 to 60 + `seconds` of a drive that falls after `good_for`.
Measurements drive(std::uint64_t seed, int seconds, int good_for, const Fall& fall) {
  constexpr int warm_up = 60;
  Vehicle vehicle(seed);
  Measurements all;
  for (int i = 0; i < warm_up + seconds; ++i) {
    if (i == warm_up + good_for) vehicle.fall(fall);
    const QualityMeasurement one = vehicle.second();
    if (i >= warm_up) all.push_back(one);
  }
  return all;
}

std::vector<JointIndexInput> joint_inputs(const Measurements& all) {
  std::vector<JointIndexInput> inputs;
  for (const QualityMeasurement& one : all) inputs.push_back(joint_input(one));
  return inputs;
}

struct Training {
  Measurements good;
  Measurements weak;
  Measurements busy;
};

Training training() {
  constexpr int drives = 10;
  constexpr int length = 600;
  Training training;
  for (std::uint64_t seed = 1; seed <= drives; ++seed) {
    const auto add = [&](Measurements& to, std::uint64_t number, const Fall& fall) {
      const Measurements all = drive(number, length, 0, fall);
      to.insert(to.end(), all.begin(), all.end());
    };
    add(training.good, seed, {"", 0, usual_load});
    add(training.weak, 100 + seed, {"", 10, usual_load});
    add(training.busy, 200 + seed, {"", 0, 0.8});
  }
  return training;
}

Measurements both(const Training& training) {
  Measurements all = training.weak;
  all.insert(all.end(), training.busy.begin(), training.busy.end());
  return all;
}

std::vector<double> qualities(const QualityIndex& index, const Measurements& all) {
  std::vector<double> values;
  for (const QualityMeasurement& one : all) values.push_back(index.evaluate(one));
  return values;
}

/// With a spread of 1 at least.
Normal broad_law_of(const std::vector<double>& values) {
  const Normal law = law_of(values);
  return {law.mean, std::max(1.0, law.sd)};
}

/// An index with a detector for its laws.
struct Entry {
  const char* index_name;
  const char* detector_name;
  QualityIndex index;
  Detector detector;
  double threshold;
};

void add_entries(const char* name, const QualityIndexParams& params, const Training& training,
                 std::vector<Entry>& entries) {
  const QualityIndex index(params);
  const Normal good = broad_law_of(qualities(index, training.good));
  const Normal bad = broad_law_of(qualities(index, both(training)));
  std::printf("%s: good %.1f +-%.1f, bad %.1f +-%.1f\n", name, good.mean, good.sd, bad.mean,
              bad.sd);
  entries.push_back({name, "CUSUM", index, Detector::cusum(NormalLlr(good, bad)), 0});
  entries.push_back(
      {name, "FOCuS", index, Detector::focus({Family::normal, {good.mean, good.sd, 0}}), 0});
}

void print_list(const char* name, const std::vector<double>& values) {
  std::printf("%s: [", name);
  for (std::size_t i = 0; i < values.size(); ++i)
    std::printf("%s%.3g", i > 0 ? ", " : "", values[i]);
  std::printf("]\n");
}

std::vector<Entry> entries_of(const Training& training) {
  const JointFit fit = fit_joint(joint_inputs(training.good),
                                 {joint_inputs(training.weak), joint_inputs(training.busy)});
  print_list("joint_center", fit.params.joint_center);
  print_list("joint_scale", fit.params.joint_scale);
  print_list("joint_fall", fit.params.joint_fall);
  print_list("joint_correlation", fit.params.joint_correlation);
  std::printf("shrinkage %.2f, distance %.2f\n", fit.shrinkage, JointIndex(fit.params).distance());
  std::vector<Entry> entries;
  QualityIndexParams params;
  add_entries("thesis", params, training, entries);
  params.quality_index = "channel";
  add_entries("channel", params, training, entries);
  params.quality_index = "joint";
  params.joint = fit.params;
  add_entries("joint", params, training, entries);
  std::fill(params.joint.joint_correlation.begin(), params.joint.joint_correlation.end(), 0.0);
  add_entries("joint, correlations 0", params, training, entries);
  params.joint = fit_joint(joint_inputs(training.good), {joint_inputs(both(training))}).params;
  add_entries("joint, one kind", params, training, entries);
  return entries;
}

void set_thresholds(std::vector<Entry>& entries, double samples) {
  constexpr int drives = 30;
  constexpr int length = 2000;
  Measurements good;
  for (std::uint64_t seed = 1; seed <= drives; ++seed) {
    const Measurements one = drive(300 + seed, length, 0, {"", 0, usual_load});
    good.insert(good.end(), one.begin(), one.end());
  }
  for (Entry& entry : entries) {
    const auto source = source_of(BlockLink{qualities(entry.index, good), length}, 4711);
    const FalseAlarmCurve curve(*source, entry.detector, {1000, 3 * samples});
    entry.threshold = curve.threshold_for(samples).value_or(1e-6);
  }
}

/// Seconds from the fall to the alarm; empty when there was one before.
std::optional<int> delay(const Entry& entry, const Measurements& all, int good_for) {
  Detector detector = entry.detector;
  for (int n = 0; n < static_cast<int>(all.size()); ++n) {
    const QualityMeasurement& one = all[static_cast<std::size_t>(n)];
    if (detector.add(entry.index.evaluate(one)) < entry.threshold) continue;
    if (n < good_for) return std::nullopt;
    return n - good_for + 1;
  }
  return static_cast<int>(all.size()) - good_for;
}

void print_table(const std::vector<Entry>& entries, int runs) {
  constexpr int good_for = 60;
  constexpr int wait = 200;
  std::vector<std::vector<double>> mean(entries.size(), std::vector<double>(falls.size(), 0));
  for (std::size_t f = 0; f < falls.size(); ++f) {
    std::vector<double> counted(entries.size(), 0);
    for (int run = 1; run <= runs; ++run) {
      const auto seed = static_cast<std::uint64_t>(1000 + run);
      const Measurements all = drive(seed, good_for + wait, good_for, falls[f]);
      for (std::size_t e = 0; e < entries.size(); ++e) {
        const auto found = delay(entries[e], all, good_for);
        if (!found) continue;
        mean[e][f] += *found;
        ++counted[e];
      }
    }
    for (std::size_t e = 0; e < entries.size(); ++e) mean[e][f] /= std::max(1.0, counted[e]);
  }
  std::printf("\n| index | detector | threshold |");
  for (const Fall& fall : falls) std::printf(" %s |", fall.name);
  std::printf("\n| --- | --- | --- |");
  for (std::size_t f = 0; f < falls.size(); ++f) std::printf(" --- |");
  for (std::size_t e = 0; e < entries.size(); ++e) {
    std::printf("\n| %s | %s | %.2f |", entries[e].index_name, entries[e].detector_name,
                entries[e].threshold);
    for (const double value : mean[e]) std::printf(" %.3g |", value);
  }
  std::printf("\n");
}

}  // namespace
}  // namespace tocsin::decision

int main(int argc, char** argv) {
  using namespace tocsin::decision;
  const double samples = argc > 1 ? std::atof(argv[1]) : 1000;
  const int runs = argc > 2 ? std::max(1, std::atoi(argv[2])) : 200;
  std::vector<Entry> entries = entries_of(training());
  set_thresholds(entries, samples);
  print_table(entries, runs);
}
