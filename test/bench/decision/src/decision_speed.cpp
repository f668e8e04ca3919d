// SPDX-License-Identifier: Apache-2.0
// Nanoseconds per sample of each detector and policy, on a trace of scenario S1.
#include <benchmark/benchmark.h>

#include <memory>
#include <string>
#include <vector>

#include "decision/belief.hpp"
#include "decision/detectors.hpp"
#include "decision/llr.hpp"
#include "decision/research/mean_cusum.hpp"
#include "decision/research/scenario.hpp"

namespace tocsin::decision {
namespace {

const std::vector<double>& trace() {
  static const std::vector<double> qni = simulate(standard_scenarios()[0], 1 << 16, 1).qni;
  return qni;
}

/// Runs `step` over the trace, round and round; time is per sample.
template <class Step>
void per_sample(benchmark::State& state, Step step) {
  const std::vector<double>& qni = trace();
  std::size_t n = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(step(qni[n]));
    n = n + 1 == qni.size() ? 0 : n + 1;
  }
}

void ratio_normal(benchmark::State& state) {
  const NormalLlr llr;
  per_sample(state, [&](double x) { return llr(x); });
}

void ratio_fitted_pair(benchmark::State& state) {
  const DensityLlr llr({Family::gev, {-0.435, 10.36, 77.55}}, {Family::rician, {35.5, 7.8, 0}}, 4);
  per_sample(state, [&](double x) { return llr(x); });
}

void cusum(benchmark::State& state) {
  const NormalLlr llr;
  Cusum sut;
  per_sample(state, [&](double x) {
    sut.add(llr(x));
    if (sut.alarm(5.53)) sut.reset();
    return sut.statistic();
  });
}

void million_cusums(benchmark::State& state) {
  const NormalLlr llr;
  std::vector<Cusum> sut(1000000);
  std::size_t i = 0;
  per_sample(state, [&](double x) {
    Cusum& one = sut[i];
    one.add(llr(x));
    if (one.alarm(5.53)) one.reset();
    i = i + 1 == sut.size() ? 0 : i + 1;
    return one.statistic();
  });
  state.SetLabel(std::to_string(sut.size() * sizeof(Cusum) / 1000000) + " MB");
}

void mean_cusum(benchmark::State& state) {
  MeanCusum sut(thesis_good.mean, 10, 60);
  per_sample(state, [&](double x) { return sut.add(x); });
}

void shiryaev_roberts(benchmark::State& state) {
  const NormalLlr llr;
  ShiryaevRoberts sut;
  per_sample(state, [&](double x) { return sut.add(llr(x)); });
}

void focus(benchmark::State& state) {
  Focus sut;
  per_sample(state, [&](double x) {
    sut.add(x);
    if (sut.alarm(6.12)) sut.reset();
    return sut.statistic();
  });
}

/// Never reset: the hull grows through every bad spell.
void focus_without_reset(benchmark::State& state) {
  Focus sut;
  per_sample(state, [&](double x) { return sut.add(x); });
}

void belief_filter(benchmark::State& state) {
  const NormalLlr llr;
  BeliefFilter sut({1 / 120.0, 1 / 20.0});
  per_sample(state, [&](double x) { return sut.add(llr(x)); });
}

void policy(benchmark::State& state, const char* name) {
  PolicyParams params;
  params.policy = name;
  const auto sut = make_policy(params);
  Time now{};
  per_sample(state, [&](double x) {
    now += std::chrono::seconds(1);
    return sut->on_sample({now, x}, now);
  });
}

BENCHMARK(ratio_normal);
BENCHMARK(ratio_fitted_pair);
BENCHMARK(cusum);
BENCHMARK(million_cusums);
BENCHMARK(mean_cusum);
BENCHMARK(shiryaev_roberts);
BENCHMARK(focus);
BENCHMARK(focus_without_reset);
BENCHMARK(belief_filter);
BENCHMARK_CAPTURE(policy, none, "none");
BENCHMARK_CAPTURE(policy, threshold, "threshold");
BENCHMARK_CAPTURE(policy, tocp, "tocp");
BENCHMARK_CAPTURE(policy, tocp_dsp, "tocp_dsp");
BENCHMARK_CAPTURE(policy, tocp_reverse, "tocp_reverse");
BENCHMARK_CAPTURE(policy, belief, "belief");
BENCHMARK_CAPTURE(policy, legacy, "legacy");

}  // namespace
}  // namespace tocsin::decision

BENCHMARK_MAIN();
