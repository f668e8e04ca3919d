// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "command_line/command.hpp"
#include "decide_report.hpp"
#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "model_file.hpp"
#include "plot.hpp"
#include "policy_settings.hpp"
#include "trace_options.hpp"

namespace tocsin::tools {
namespace {

struct Request {
  std::string file;
  std::string policy;
  std::string model;
  std::vector<std::string> set;
  std::string table;
  std::string plot;
  bool json = false;
  bool rows = false;
  TraceOptions trace;
};

void declare(CLI::App& app, Request& request) {
  app.add_option("TRACE", request.file, "recorded quality: CSV, a bag, or a recorder's folder")
      ->required();
  app.add_option("--policy", request.policy,
                 "none, threshold, tocp, tocp_dsp, ..., or oracle [the recorded run's]");
  app.add_option("--model", request.model, "model file as tocsin fit writes it");
  app.add_option("--set", request.set, "parameter of the policy: key=value")
      ->expected(1)
      ->take_all();
  app.add_option("--table", request.table, "CSV file to write, a row per sample; - prints it");
  app.add_option("--plot", request.plot, "draw PREFIX.png and PREFIX.svg");
  CLI::Option* json = app.add_flag("--json", request.json, "print JSON");
  app.add_flag("--rows", request.rows, "with --json: every row, not only changes")->needs(json);
  request.trace.topic = "transmission_state";
  declare_trace_options(app, request.trace);
}

int decide(const Request& request) {
  const bool print_table = request.table == "-";
  if (print_table && request.json) {
    throw ConfigError("--table -: prints the table in place of the JSON; leave one of them out");
  }
  const QualityTrace trace = read_quality_trace(request.file, request.trace);
  const PolicySettings settings =
      load_settings({trace.controller, request.model, request.set, request.policy});
  if (!trace.controller && !names_policy(settings)) {
    throw ConfigError(request.file + ": is of no run, so that --policy must name one of: " +
                      joined_of(decision::policy_names, [](const char* name) { return name; }) +
                      ", oracle");
  }
  const DecidedTrace decided = decide_again(trace, request.policy, settings);
  if (!request.table.empty() && !print_table) write_text(request.table, to_csv(decided));
  if (!request.plot.empty()) draw(decide_plot(decided), request.plot);
  if (print_table) {
    std::printf("%s", to_csv(decided).c_str());
  } else if (request.json) {
    std::printf("%s\n", to_json(decided, request.rows).dump(2).c_str());
  } else {
    std::printf("%s", to_text(decided).c_str());
  }
  return 0;
}

}  // namespace
}  // namespace tocsin::tools

int main(int argc, char** argv) {
  CLI::App app{"Decide a recorded trace again, with another policy or other settings",
               "tocsin decide"};
  tocsin::tools::Request request;
  declare(app, request);
  return tocsin::run_command(app, argc, argv, [&] { return decide(request); });
}
