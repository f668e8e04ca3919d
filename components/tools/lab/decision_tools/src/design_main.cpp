// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "command_line/command.hpp"
#include "command_line/option_checks.hpp"
#include "design.hpp"
#include "policy_settings.hpp"
#include "trace_options.hpp"

namespace tocsin::tools {
namespace {

struct Request {
  DesignRequest design;
  std::string false_alarm;
  std::string model;
  std::vector<std::string> set;
  std::string recording;
  bool json = false;
  TraceOptions trace;
};

void declare(CLI::App& app, Request& request) {
  app.add_option("--false-alarm", request.false_alarm,
                 "mean time between false alarms: 90s, 5min, 1h, 2d")
      ->required();
  app.add_option("--period", request.design.period_s, "seconds between samples [6]")
      ->check(above_zero());
  app.add_option("--model", request.model, "model file as tocsin fit writes it");
  app.add_option("--set", request.set, "parameter of the policy: key=value")
      ->expected(1)
      ->take_all();
  app.add_option("--recording", request.recording,
                 "quality of a good network to calibrate on, CSV");
  app.add_option("--column", request.trace.column,
                 "column of the recording [qni or what it rests on]");
  app.add_option("--block", request.design.block_s,
                 "seconds per resampled block of the recording [as long as its correlation lasts]")
      ->check(above_zero());
  app.add_option("--seed", request.design.seed, "of the resampling [1]")->check(is_seed());
  app.add_flag("--json", request.json, "print JSON");
}

int run(Request request) {
  request.design.false_alarm_s = parse_duration_s("--false-alarm", request.false_alarm);
  request.design.params = load_settings({{}, request.model, request.set, ""}).params;
  request.trace.period_s = request.design.period_s;
  if (!request.recording.empty()) {
    request.design.recording = read_quality_trace(request.recording, request.trace);
  }
  const Design result = design(request.design);
  std::printf("%s\n", request.json ? to_json(result).dump(2).c_str() : to_text(result).c_str());
  return 0;
}

}  // namespace
}  // namespace tocsin::tools

int main(int argc, char** argv) {
  CLI::App app{"Choose the threshold of the detector from a wanted time between false alarms",
               "tocsin design"};
  tocsin::tools::Request request;
  declare(app, request);
  return tocsin::run_command(app, argc, argv, [&] { return run(request); });
}
