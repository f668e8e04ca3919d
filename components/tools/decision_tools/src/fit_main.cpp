// SPDX-License-Identifier: Apache-2.0
#include <cstdio>

#include "command_line/command.hpp"
#include "fit_report.hpp"
#include "foundation/error.hpp"
#include "foundation/joined.hpp"
#include "joint_report.hpp"
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
  bool joint = false;
  std::vector<std::string> other_bad;
  TraceOptions trace;
};

void declare(CLI::App& app, Request& request) {
  app.add_option("GOOD", request.good, "recording of a good network: CSV, or a bag")->required();
  app.add_option("BAD", request.bad, "recording of a bad network: CSV, or a bag")->required();
  app.add_option("--family", request.family, "use this family for both [the smallest BIC of each]");
  app.add_option("--model", request.model, "file to write: the laws as parameters of a policy");
  app.add_option("--plot", request.plot, "draw PREFIX.png and PREFIX.svg");
  app.add_flag("--json", request.json, "print JSON");
  CLI::Option* joint = app.add_flag(
      "--joint", request.joint,
      "fit the joint index of all readings to recorded network_quality.csv, with its laws");
  app.add_option("--other-bad", request.other_bad, "with --joint: another kind of bad network, CSV")
      ->expected(1)
      ->take_all()
      ->needs(joint);
  declare_trace_options(app, request.trace);
}

void check(const Request& request, const std::string& model) {
  try {
    check_model(model);
  } catch (const ConfigError& error) {
    throw ConfigError(request.good + " (good), " + request.bad + " (bad): " + error.what());
  }
}

int fit_all_readings(const Request& request) {
  std::vector<std::string> bad{request.bad};
  bad.insert(bad.end(), request.other_bad.begin(), request.other_bad.end());
  const auto fitted = fit_joint_files(request.good, bad);
  const std::string text =
      joint_text(fitted, "fitted by tocsin fit --joint " + request.good + " " + joined(bad, " "));
  if (!request.model.empty()) write_text(request.model, text);
  std::printf("%s", text.c_str());
  return 0;
}

int fit(const Request& request) {
  if (request.joint) return fit_all_readings(request);
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
