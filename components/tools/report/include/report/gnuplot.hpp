// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>

namespace tocsin::report {

/// A colour of a line, as gnuplot wants it: rgb '#rrggbb'. One after the other they are colours
/// that people with red-green blindness tell apart (Okabe and Ito), and then begin again.
[[nodiscard]] std::string gnuplot_colour(std::size_t index);

/// A text as a word of a gnuplot script: quoted, and nothing in it is a command.
[[nodiscard]] std::string gnuplot_text(const std::string& text);

/// Runs a script, in which paths are relative to `folder`. Throws EnvironmentError with what
/// gnuplot said, or that it is not there (package gnuplot-nox).
void run_gnuplot(const std::string& script, const std::string& folder);

}  // namespace tocsin::report
