// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "command_line.hpp"
#include "decision/llr.hpp"
#include "fit_report.hpp"
#include "foundation/program.hpp"
#include "model_file.hpp"
#include "plot.hpp"

namespace tocsin::tools {
namespace {

int body(int argc, char** argv) {
  CLI::App app{"Fit laws to the quality of a good and of a bad network; write a model file"};
  app.name("tocsin fit");
  std::string good_file;
  std::string bad_file;
  std::string family;
  std::string model;
  std::string plot;
  bool json = false;
  TraceOptions options;
  app.add_option("GOOD", good_file, "recording of a good network, CSV")->required();
  app.add_option("BAD", bad_file, "recording of a bad network, CSV")->required();
  app.add_option("--family", family, "use this family for both [the smallest BIC of each]");
  app.add_option("--model", model, "file to write: the laws as parameters of a policy");
  app.add_option("--plot", plot, "draw PREFIX.png and PREFIX.svg");
  app.add_flag("--json", json, "print JSON");
  declare_trace_options(app, options);
  if (!parse(app, argc, argv)) return 0;

  const FitReport good = fit_trace(read_quality_trace(good_file, options), family);
  const FitReport bad = fit_trace(read_quality_trace(bad_file, options), family);
  (void)decision::DensityLlr(good.chosen, bad.chosen, 0);  // the wrong way round, no mass
  const std::string text =
      model_text(good.chosen, bad.chosen, "fitted by tocsin fit " + good_file + " " + bad_file);
  if (!model.empty()) write_text(model, text);
  if (!plot.empty()) draw(fit_plot(good, bad), plot);
  if (json) {
    std::printf("%s\n",
                nlohmann::json{{"good", to_json(good)}, {"bad", to_json(bad)}}.dump(2).c_str());
  } else {
    std::printf("%s\n%s\n%s", to_text(good).c_str(), to_text(bad).c_str(), text.c_str());
  }
  return 0;
}

}  // namespace
}  // namespace tocsin::tools

int main(int argc, char** argv) {
  return tocsin::run_program("tocsin fit", [&] { return tocsin::tools::body(argc, argv); });
}
