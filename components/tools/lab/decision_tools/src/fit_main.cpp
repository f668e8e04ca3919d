// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "command_line/command.hpp"
#include "fit_report.hpp"
#include "foundation/error.hpp"
#include "model_file.hpp"
#include "plot.hpp"
#include "trace_options.hpp"

namespace tocsin::tools {
namespace {

struct Request {
  std::string good;
  std::string bad;
  std::string family;
  std::string model;
  std::string plot;
  bool json = false;
  TraceOptions trace;
};

void declare(CLI::App& app, Request& request) {
  app.add_option("GOOD", request.good, "recording of a good network: CSV, or a bag")->required();
  app.add_option("BAD", request.bad, "recording of a bad network: CSV, or a bag")->required();
  app.add_option("--family", request.family, "use this family for both [the smallest BIC of each]");
  app.add_option("--model", request.model, "file to write: the laws as parameters of a policy");
  app.add_option("--plot", request.plot, "draw PREFIX.png and PREFIX.svg");
  app.add_flag("--json", request.json, "print JSON");
  declare_trace_options(app, request.trace);
}

void check(const Request& request, const std::string& model) {
  try {
    check_model(model);
  } catch (const ConfigError& error) {
    throw ConfigError(request.good + " (good), " + request.bad + " (bad): " + error.what());
  }
}

int fit(const Request& request) {
  const FitReport good = fit_trace(read_quality_trace(request.good, request.trace), request.family);
  const FitReport bad = fit_trace(read_quality_trace(request.bad, request.trace), request.family);
  const std::string text = model_text(good.chosen, bad.chosen,
                                      "fitted by tocsin fit " + request.good + " " + request.bad);
  check(request, text);
  if (!request.model.empty()) write_text(request.model, text);
  if (!request.plot.empty()) draw(fit_plot(good, bad), request.plot);
  if (request.json) {
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
  CLI::App app{"Fit laws to the quality of a good and of a bad network; write a model file",
               "tocsin fit"};
  tocsin::tools::Request request;
  declare(app, request);
  return tocsin::run_command(app, argc, argv, [&] { return fit(request); });
}
