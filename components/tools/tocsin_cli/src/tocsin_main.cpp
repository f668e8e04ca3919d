// SPDX-License-Identifier: Apache-2.0
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "command_line/programs.hpp"
#include "command_line/run_to_end.hpp"
#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/program.hpp"
#include "foundation/spelling.hpp"

namespace tocsin::cli {
namespace {

/// What all of the repository's packages bring, and the Debian package that has it. `bringup/demo`
/// builds some of them only.
struct Shipped {
  std::string_view package;
  std::vector<std::string_view> verbs;
};

const std::array<Shipped, 3> shipped{
    {{"tocsin",
      {"action",   "bag",    "check",   "component", "dock", "doctor", "estop", "interface",
       "keystore", "kobuki", "launch",  "lifecycle", "log",  "map",    "node",  "param",
       "qos",      "run",    "service", "teleop",    "top",  "topic"}},
     {"tocsin-archive", {"archive"}},
     {"tocsin-sim", {"decide", "design", "experiment", "fit", "report", "sim"}}}};

/// The first line that the verb's program prints with --help.
std::string description(const std::string& verb, const Folders& folders) {
  const auto program = find_program("tocsin-" + verb, folders);
  const Ended help = run_to_end({program->string(), "--help"});
  return help.code == 0 ? printable(help.output.substr(0, help.output.find('\n'))) : "";
}

int print_help(const Folders& folders) {
  std::printf(
      "usage: tocsin VERB [ARGUMENT...] | --help | --version\n\nVerbs (tocsin VERB --help tells "
      "more):\n");
  for (const std::string& verb : find_verbs(folders)) {
    std::printf("  %-12s %s\n", verb.c_str(), description(verb, folders).c_str());
  }
  return 0;
}

[[noreturn]] void reject(const std::string& verb, const Folders& folders) {
  for (const auto& [package, verbs] : shipped) {
    if (std::find(verbs.begin(), verbs.end(), verb) == verbs.end()) continue;
    throw EnvironmentError("'" + verb + "' is not here; bringup/build run builds it, package " +
                           std::string(package) + " has it");
  }
  throw ConfigError("'" + verb + "' is not a verb" +
                    did_you_mean(find_verbs(folders), verb, "the verbs are"));
}

int body(char** argv) {
  const Folders folders = program_folders();
  if (argv[1] == nullptr) throw ConfigError("a verb is missing; tocsin --help lists them");
  const std::string verb = argv[1];
  if (verb == "--help" || verb == "-h" || verb == "help") return print_help(folders);
  if (verb == "--version") {
    std::printf("tocsin %s (commit %s, Fast DDS %s)\n", TOCSIN_VERSION,
                TOCSIN_COMMIT[0] == '\0' ? "unknown" : TOCSIN_COMMIT, FAST_DDS_VERSION);
    return 0;
  }
  const auto program =
      verb.find('/') == std::string::npos ? find_program("tocsin-" + verb, folders) : std::nullopt;
  if (!program) reject(verb, folders);
  ::execv(program->c_str(), argv + 1);
  throw EnvironmentError(program->string() + ": " + std::strerror(errno));
}

}  // namespace
}  // namespace tocsin::cli

int main(int, char** argv) {
  return tocsin::run_program("tocsin", [&] { return tocsin::cli::body(argv); });
}
