// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "command_line.hpp"
#include "decide_report.hpp"
#include "foundation/program.hpp"
#include "model_file.hpp"
#include "plot.hpp"

namespace tocsin::tools {
namespace {

int body(int argc, char** argv) {
  CLI::App app{"Decide a recorded trace again, with another policy or other settings"};
  app.name("tocsin decide");
  std::string file;
  std::string policy;
  std::string model;
  std::vector<std::string> set;
  std::string table;
  std::string plot;
  bool json = false;
  bool rows = false;
  TraceOptions options;
  app.add_option("TRACE", file, "recorded quality, CSV")->required();
  app.add_option("--policy", policy, "none, threshold, tocp, tocp_dsp, ..., or oracle");
  app.add_option("--model", model, "model file as tocsin fit writes it");
  app.add_option("--set", set, "parameter of the policy: key=value")->expected(1)->take_all();
  app.add_option("--table", table, "CSV file to write, a row per sample; - prints it");
  app.add_option("--plot", plot, "draw PREFIX.png and PREFIX.svg");
  app.add_flag("--json", json, "print JSON");
  app.add_flag("--rows", rows, "with --json: every row, not only changes");
  declare_trace_options(app, options);
  if (!parse(app, argc, argv)) return 0;

  const decision::PolicyParams params = load_model(model, set);
  const DecidedTrace decided = decide_again(read_quality_trace(file, options), policy, params);
  if (!table.empty() && table != "-") write_text(table, to_csv(decided));
  if (!plot.empty()) draw(decide_plot(decided), plot);
  if (table == "-") {
    std::printf("%s", to_csv(decided).c_str());
  } else if (json) {
    std::printf("%s\n", to_json(decided, rows).dump(2).c_str());
  } else {
    std::printf("%s", to_text(decided).c_str());
  }
  return 0;
}

}  // namespace
}  // namespace tocsin::tools

int main(int argc, char** argv) {
  return tocsin::run_program("tocsin decide", [&] { return tocsin::tools::body(argc, argv); });
}
