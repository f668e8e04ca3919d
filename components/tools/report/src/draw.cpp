// SPDX-License-Identifier: Apache-2.0
#include "report/draw.hpp"

#include "command_line/programs.hpp"
#include "command_line/run_to_end.hpp"
#include "foundation/error.hpp"

namespace tocsin::report {

void draw(const std::string& picture, const std::string& prefix) {
  const auto program = find_program("draw_panels", program_folders());
  if (!program) throw EnvironmentError("nothing can be drawn: draw_panels is not installed");
  // Debian's Python, for which bringup/packages.txt has matplotlib; another may come first in PATH.
  const Ended ended = run_to_end({"/usr/bin/python3", "-B", *program, prefix}, {picture, ""});
  if (ended.code == 0) return;
  const std::string said = ended.output.substr(0, ended.output.find_last_not_of('\n') + 1);
  throw EnvironmentError("nothing can be drawn: " + said.substr(said.rfind('\n') + 1));
}

}  // namespace tocsin::report
