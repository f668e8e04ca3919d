// SPDX-License-Identifier: Apache-2.0
#include "check_first.hpp"

#include <cstdio>

#include "command_line/run_to_end.hpp"

namespace tocsin::cli {

bool check_first(const BringupOptions& options, const std::filesystem::path& program) {
  std::vector<std::string> command = options.arguments();
  command.insert(command.begin(), {program.string(), "--quiet"});
  const Ended ended = run_to_end(command);
  std::fputs(ended.output.c_str(), stderr);
  return ended.code == 0;
}

}  // namespace tocsin::cli
