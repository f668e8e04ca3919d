// SPDX-License-Identifier: Apache-2.0
#include "plot.hpp"

#include <filesystem>
#include <utility>

#include "foundation/error.hpp"
#include "report/gnuplot.hpp"

namespace tocsin::tools {
namespace {

void check_folder(const std::string& prefix) {
  const auto folder = std::filesystem::path(prefix).parent_path();
  if (folder.empty() || std::filesystem::is_directory(folder)) return;
  throw ConfigError("--plot: folder " + folder.string() + " does not exist");
}

}  // namespace

void draw(const std::string& script, const std::string& prefix) {
  check_folder(prefix);
  std::string all = "set encoding utf8\n";
  for (const auto& [terminal, kind] : {std::pair("pngcairo", ".png"), std::pair("svg", ".svg")}) {
    all += std::string("set terminal ") + terminal + " noenhanced size 1200,700\nset output " +
           report::gnuplot_text(prefix + kind) + "\n" + script + "\nunset output\nreset\n";
  }
  report::run_gnuplot(all, "");
}

}  // namespace tocsin::tools
