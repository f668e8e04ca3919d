// SPDX-License-Identifier: Apache-2.0
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "command_line/programs.hpp"
#include "foundation/error.hpp"
#include "foundation/printable.hpp"
#include "foundation/program.hpp"

namespace tocsin::cli {
namespace {

/// The first line that the verb's program prints with --help.
std::string description(const std::string& verb, const Folders& folders) {
  const auto program = find_program("tocsin-" + verb, folders);
  const std::string command = "'" + program->string() + "' --help 2>/dev/null";
  const std::unique_ptr<FILE, int (*)(FILE*)> output(::popen(command.c_str(), "r"), ::pclose);
  std::array<char, 200> line{};
  if (!output || std::fgets(line.data(), line.size(), output.get()) == nullptr) return "";
  std::string text = line.data();
  while (std::fgets(line.data(), line.size(), output.get()) != nullptr) {
  }
  return printable(text.substr(0, text.find('\n')));
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

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

[[noreturn]] void reject(const std::string& verb, const Folders& folders) {
  const auto verbs = find_verbs(folders);
  const auto near = similar(verbs, verb);
  throw ConfigError(
      "'" + verb + "' is not a verb; " +
      (near.empty() ? "the verbs are: " + joined(verbs) : "did you mean: " + joined(near) + "?"));
}

int body(char** argv) {
  const Folders folders = program_folders();
  if (argv[1] == nullptr) throw ConfigError("a verb is missing; tocsin --help lists them");
  const std::string verb = argv[1];
  if (verb == "--help" || verb == "-h" || verb == "help") return print_help(folders);
  if (verb == "--version") {
    std::printf("tocsin %s\n", TOCSIN_VERSION);
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
