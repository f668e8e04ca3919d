// SPDX-License-Identifier: Apache-2.0
#include "report/gnuplot.hpp"

#include <array>
#include <sstream>

#include "command_line/run_to_end.hpp"
#include "foundation/error.hpp"

namespace tocsin::report {
namespace {

constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                             "#e69f00", "#56b4e9", "#000000"};

/// Its words with one space before each.
std::string one_line(const std::string& text) {
  std::istringstream words(text);
  std::string line;
  for (std::string word; words >> word;) line += " " + word;
  return line;
}

Ended run(const std::string& script, const std::string& folder) {
  try {
    return run_to_end({"gnuplot", "-"}, {script, folder});
  } catch (const EnvironmentError& error) {
    throw EnvironmentError(std::string("nothing can be drawn without gnuplot (package "
                                       "gnuplot-nox): ") +
                           error.what());
  }
}

}  // namespace

std::string gnuplot_colour(std::size_t index) {
  return std::string("rgb '") + colours.at(index % colours.size()) + "'";
}

std::string gnuplot_text(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '`') {
      quoted += "\\140";  // gnuplot runs what stands between two of them
    } else if (c == '"' || c == '\\') {
      quoted += std::string("\\") + c;
    } else {
      quoted += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return quoted + "\"";
}

void run_gnuplot(const std::string& script, const std::string& folder) {
  const Ended ended = run(script, folder);
  if (ended.code != 0) throw EnvironmentError("gnuplot failed:" + one_line(ended.output));
}

}  // namespace tocsin::report
