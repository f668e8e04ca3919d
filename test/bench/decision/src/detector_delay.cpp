// SPDX-License-Identifier: Apache-2.0
// How long each detector takes to find a fall of the quality, at equal rates of false alarms, on
// independent and correlated links. Thresholds are taken from the link itself, simulated, so that
// only detectors differ.
// usage: detector_delay [SAMPLES [RUNS [TRACE.csv...]]]
//   SAMPLES between false alarms [1000], RUNS falls for each delay [4000]; each TRACE (column qni)
//   is one more link, its blocks of 30 samples strung together.
// A link is good for 100 samples, then its quality falls; runs with an alarm before are left out.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "decision/design/link_model.hpp"
#include "foundation/csv_table.hpp"
#include "recording.hpp"

namespace tocsin::decision {
namespace {

struct Link {
  std::string name;
  LinkModel model;
  Normal good;
};

/// How far the quality has fallen n samples after the begin.
struct Fall {
  const char* name;
  std::function<double(int)> depth;  ///< in standard deviations of the good link
};

const std::vector<Fall> falls{{"sudden, 4.4 sd", [](int) { return 4.353; }},
                              {"2.1 sd (to 60)", [](int) { return 2.088; }},
                              {"mild, 1.12 sd (to 70)", [](int) { return 1.1197; }},
                              {"0.64 sd (to 75)", [](int) { return 0.6356; }},
                              {"ramp, 0.1 sd a sample", [](int n) { return 0.1 * n; }},
                              {"ramp, 0.02 sd a sample", [](int n) { return 0.02 * n; }}};

struct Entry {
  std::string name;
  std::shared_ptr<Detector> detector;
};

std::vector<Entry> entries(const Normal& good) {
  const double s = good.sd / thesis_good.sd;
  const Normal bad{good.mean - 4.353 * good.sd, thesis_bad.sd * s};
  const Normal mild{good.mean - 1.1197 * good.sd, good.sd};
  return {{"CUSUM", std::make_shared<CusumDetector>(NormalLlr(good, bad))},
          {"CUSUM clipped at 4", std::make_shared<CusumDetector>(NormalLlr(good, bad, 4))},
          {"FOCuS", std::make_shared<Focus>(good)},
          {"CUSUM for 70", std::make_shared<CusumDetector>(NormalLlr(good, mild))}};
}

/// Mean samples from the fall to the statistic `threshold`.
double delay(const Link& link, Detector& detector, double threshold, const Fall& fall, int runs) {
  constexpr int before = 100;
  constexpr int longest = 20000;
  const auto source = source_of(link.model, 99);
  double samples = 0;
  int counted = 0;
  for (int i = 0; i < runs; ++i) {
    detector.reset();
    source->restart();
    bool alarm = false;
    for (int n = 0; n < before && !alarm; ++n) alarm = detector.add(source->next()) >= threshold;
    if (alarm) continue;
    int n = 0;
    while (!alarm && n < longest) {
      ++n;
      const double quality = source->next() - fall.depth(n) * link.good.sd;
      alarm = detector.add(std::clamp(quality, 0.0, 100.0)) >= threshold;
    }
    samples += n;
    ++counted;
  }
  return samples / std::max(1, counted);
}

void print(const Link& link, double samples, int runs) {
  std::printf("\n%s, a false alarm per %.0f samples:\n\n| detector | threshold |",
              link.name.c_str(), samples);
  for (const Fall& fall : falls) std::printf(" %s |", fall.name);
  std::printf("\n| --- | --- |");
  for (std::size_t i = 0; i < falls.size(); ++i) std::printf(" --- |");
  for (Entry& entry : entries(link.good)) {
    const auto source = source_of(link.model, 4711);
    const auto threshold =
        FalseAlarmCurve(*source, *entry.detector, {1000, 3 * samples}).threshold_for(samples);
    if (!threshold) {
      std::printf("\n| %s | none is so low |", entry.name.c_str());
      continue;
    }
    std::printf("\n| %s | %.2f |", entry.name.c_str(), *threshold);
    for (const Fall& fall : falls) {
      std::printf(" %.3g |", delay(link, *entry.detector, *threshold, fall, runs));
    }
    std::fflush(stdout);
  }
  std::printf("\n");
}

Link trace(const std::string& path) {
  const std::vector<double> recording = CsvTable::read(path).numbers("qni");
  return {name_of(path), BlockLink{recording, 30}, law_of(recording)};
}

}  // namespace
}  // namespace tocsin::decision

int main(int argc, char** argv) {
  using namespace tocsin::decision;
  const double samples = argc > 1 ? std::atof(argv[1]) : 1000;
  const int runs = argc > 2 ? std::atoi(argv[2]) : 4000;
  std::vector<Link> links{{"independent", Ar1Link{thesis_good, 0}, thesis_good},
                          {"AR(1) 0.5", Ar1Link{thesis_good, 0.5}, thesis_good},
                          {"AR(1) 0.9", Ar1Link{thesis_good, 0.9}, thesis_good}};
  for (int i = 3; i < argc; ++i) links.push_back(trace(argv[i]));
  for (const Link& link : links) print(link, samples, runs);
}
