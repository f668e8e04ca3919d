// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "command_line.hpp"
#include "design.hpp"
#include "foundation/error.hpp"
#include "foundation/program.hpp"
#include "model_file.hpp"

namespace tocsin::tools {
namespace {

int body(int argc, char** argv) {
  CLI::App app{"Choose the threshold of the detector from a wanted time between false alarms"};
  app.name("tocsin design");
  std::string false_alarm;
  std::string model;
  std::vector<std::string> set;
  std::string recording;
  bool json = false;
  DesignRequest request;
  TraceOptions options;
  app.add_option("--false-alarm", false_alarm, "mean time between false alarms: 90s, 5min, 1h, 2d")
      ->required();
  app.add_option("--period", request.period_s, "seconds between samples [6]")
      ->check(CLI::PositiveNumber);
  app.add_option("--model", model, "model file as tocsin fit writes it");
  app.add_option("--set", set, "parameter of the policy: key=value")->expected(1)->take_all();
  app.add_option("--recording", recording, "quality of a good network to calibrate on, CSV");
  app.add_option("--column", options.column, "column of the recording [qni or what it rests on]");
  app.add_option("--block", request.block_s, "seconds per resampled block of the recording [30]")
      ->check(CLI::PositiveNumber);
  app.add_option("--seed", request.seed, "of the resampling [1]");
  app.add_flag("--json", json, "print JSON");
  if (!parse(app, argc, argv)) return 0;

  request.false_alarm_s = parse_duration_s("--false-alarm", false_alarm);
  request.params = load_model(model, set);
  options.period_s = request.period_s;
  if (!recording.empty()) request.recording = read_quality_trace(recording, options);
  const Design result = design(request);
  std::printf("%s\n", json ? to_json(result).dump(2).c_str() : to_text(result).c_str());
  return 0;
}

}  // namespace
}  // namespace tocsin::tools

int main(int argc, char** argv) {
  return tocsin::run_program("tocsin design", [&] { return tocsin::tools::body(argc, argv); });
}
