// SPDX-License-Identifier: Apache-2.0
// Does `tocsin design --recording` keep its promise? Links of known truth are recorded, a threshold
// is calibrated on each recording, and the true mean time between false alarms is looked up.
// usage: calibration_coverage [CASES [SAMPLES [WANTED [LINK...]]]]
//   CASES recordings of each link [40], of SAMPLES samples each [7200], for a false alarm each
//   WANTED samples [3600]. LINK is a correlation (0.9: AR(1)), passers-by, doors or rare (two
//   states), or a CSV with a column qni, whose blocks are strung together; without any, all but
//   the last.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "decision/design/calibration.hpp"
#include "foundation/csv_table.hpp"
#include "recording.hpp"

namespace tocsin::decision {
namespace {

struct Link {
  std::string name;
  LinkModel model;
  Llr llr;
};

Link ar1(double correlation) {
  char name[40];
  std::snprintf(name, sizeof name, "AR(1) %.2f", correlation);
  return {name, Ar1Link{thesis_good, correlation}, NormalLlr()};
}

Link two_state(const std::string& name, const TwoStateLink& link) {
  return {"two states, " + name, link, NormalLlr()};
}

/// A recorded quality, one a second (column qni), as a link of resampled blocks.
Link trace(const std::string& path) {
  const std::vector<double> recording = CsvTable::read(path).numbers("qni");
  const Normal good = law_of(recording);
  return {name_of(path), BlockLink{recording, 30},
          NormalLlr(good, {good.mean - 2 * good.sd, good.sd})};
}

Link link_of(const std::string& name) {
  if (name == "passers-by") return two_state(name, {{84, 7}, {68, 7}, 0.01, 0.05});
  if (name == "doors") return two_state(name, {{82, 8}, {72, 8}, 0.005, 0.005});
  if (name == "rare") return two_state(name, {{82, 8}, {60, 8}, 0.001, 0.1});
  char* end = nullptr;
  const double correlation = std::strtod(name.c_str(), &end);
  return *end == 0 ? ar1(correlation) : trace(name);
}

struct Options {
  int cases = 40;
  std::size_t samples = 7200;
  double wanted = 3600;
};

/// ln of the run length of an AR(1) link with mean, ln sd of what is new in each sample,
/// correlation.
double log_run_length(const std::array<double, 3>& p, const Link& link, double threshold,
                      const Options& options) {
  const Ar1Link model{{p[0], std::exp(p[1]) / std::sqrt(1 - p[2] * p[2])}, p[2]};
  const auto source = source_of(model, 31);
  CusumDetector cusum(link.llr);
  return std::log(
      FalseAlarmCurve(*source, cusum, {2000, 3 * options.wanted}).run_length(threshold));
}

/// The least standard deviation that any unbiased estimate of ln(run length) from such a recording
/// can have (Cramer and Rao): Fisher's information of the three numbers is known in closed form,
/// the run length's gradient is simulated. NaN for other links.
double least_sd(const Link& link, double threshold, const Options& options) {
  const auto* model = std::get_if<Ar1Link>(&link.model);
  if (model == nullptr) return std::nan("");
  const double phi = model->correlation;
  const double n = static_cast<double>(options.samples);
  const std::array<double, 3> at{model->law.mean,
                                 std::log(model->law.sd * std::sqrt(1 - phi * phi)), phi};
  const std::array<double, 3> sd{model->law.sd * std::sqrt((1 + phi) / (1 - phi) / n),
                                 std::sqrt(0.5 / n), std::sqrt((1 - phi * phi) / n)};
  double variance = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    auto up = at;
    auto down = at;
    up[i] += sd[i];
    down[i] -= sd[i];
    const double slope = (log_run_length(up, link, threshold, options) -
                          log_run_length(down, link, threshold, options)) /
                         2;
    variance += slope * slope;
  }
  return std::sqrt(variance);
}

/// How many of normal logs with that spread lie within 20 %, in percent.
double share_within(double sd) {
  const auto cdf = [&](double x) { return std::erfc(-x / sd * M_SQRT1_2) / 2; };
  return 100 * (cdf(std::log(1.2)) - cdf(std::log(0.8)));
}

struct Score {
  int covered = 0;
  int within = 0;
  int sound = 0;
  int unbounded = 0;
  std::vector<double> logs;
  std::vector<double> halves;
  std::vector<double> needed;
  double least_sd = 0;
};

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<long>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

Score play(const Link& link, const Options& options) {
  const auto truth_source = source_of(link.model, 424242);
  const auto cusum = std::make_shared<CusumDetector>(link.llr);
  const FalseAlarmCurve truth(*truth_source, *cusum, {3000, 3 * options.wanted});
  Score score;
  score.least_sd = least_sd(link, truth.threshold_for(options.wanted).value_or(1e-6), options);
  for (int i = 0; i < options.cases; ++i) {
    const auto source = source_of(link.model, 77000 + static_cast<std::uint64_t>(i));
    CalibrationRequest request{{}, cusum, options.wanted};
    for (std::size_t n = 0; n < options.samples; ++n) request.qualities.push_back(source->next());
    request.replicates = 30;
    request.paths = 1000;
    request.seed = 5000 + static_cast<std::uint64_t>(i) * 1000;
    const Calibration found = calibrate(request);
    const double real = truth.run_length(found.threshold);
    score.covered += real >= found.true_samples.low && real <= found.true_samples.high;
    score.within += std::abs(real / options.wanted - 1) <= 0.2;
    score.sound += found.fit.model.index() == link.model.index();
    score.unbounded += found.any_threshold;
    score.logs.push_back(std::log(real / options.wanted));
    score.halves.push_back(std::sqrt(found.true_samples.high / found.true_samples.low));
    score.needed.push_back(found.needed_samples);
  }
  return score;
}

void print(const Link& link, const Options& options, const Score& score) {
  const double n = options.cases;
  double mean = 0;
  double square = 0;
  for (const double one : score.logs) mean += one / n;
  for (const double one : score.logs) square += (one - mean) * (one - mean) / (n - 1);
  char limit[60] = "";
  if (!std::isnan(score.least_sd)) {
    std::snprintf(limit, sizeof limit, "%.2f, %.0f %%", score.least_sd,
                  share_within(score.least_sd));
  }
  std::printf("| %s | %.0f | %.0f | %.2f | %.2f | %s | x%.2f | %.0f | %.0f | %.0f |\n",
              link.name.c_str(), 100 * score.covered / n, 100 * score.within / n, std::exp(mean),
              std::sqrt(square), limit, median(score.halves), median(score.needed) / 3600,
              100 * score.sound / n, 100 * score.unbounded / n);
  std::fflush(stdout);
}

}  // namespace
}  // namespace tocsin::decision

int main(int argc, char** argv) {
  using namespace tocsin::decision;
  Options options;
  if (argc > 1) options.cases = std::atoi(argv[1]);
  if (argc > 2) options.samples = static_cast<std::size_t>(std::atol(argv[2]));
  if (argc > 3) options.wanted = std::atof(argv[3]);
  std::vector<std::string> links(argv + std::min(argc, 4), argv + argc);
  if (links.empty()) {
    links = {"0", "0.5", "0.8", "0.9", "0.95", "0.98", "passers-by", "doors", "rare"};
  }
  std::printf(
      "| link | covered, %% | within 20 %%, %% | mean ratio | sd of its log "
      "| least sd, share within 20 %% it allows | half interval "
      "| hours for 20 %% | own model found, %% | no bound, %% |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::string& name : links) {
    const Link link = link_of(name);
    print(link, options, play(link, options));
  }
}
