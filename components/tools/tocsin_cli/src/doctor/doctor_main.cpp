// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

#include "command_line/bringup_options.hpp"
#include "command_line/command.hpp"
#include "equipment.hpp"
#include "foundation/error.hpp"
#include "foundation/file_descriptor.hpp"
#include "leftovers.hpp"
#include "limits.hpp"

namespace tocsin::doctor {
namespace {

std::optional<std::string> read_sysctl(std::string name) {
  for (char& c : name) c = c == '.' ? '/' : c;
  std::ifstream file("/proc/sys/" + name);
  if (!file) return std::nullopt;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// 0 when it can be opened for reading and writing, else the errno.
int error_of_opening(const char* device) {
  return FileDescriptor(::open(device, O_RDWR | O_CLOEXEC)) ? 0 : errno;
}

Advice judge_shared_memory(bool clean) {
  const Leftovers leftovers = find_leftovers("/dev/shm");
  if (leftovers.files.empty())
    return {Fitness::good, "/dev/shm: nothing left by dead processes", ""};
  const std::string found = std::to_string(leftovers.files.size()) + " files, " +
                            std::to_string(leftovers.bytes / 1024) + " KiB";
  if (clean) {
    return {Fitness::good,
            "/dev/shm: removed " + std::to_string(remove(leftovers)) + " of " + found, ""};
  }
  return {Fitness::bad, "/dev/shm: " + found + " left by dead processes", "tocsin doctor --clean"};
}

int print(const Advices& advices) {
  const std::map<Fitness, const char*> words{
      {Fitness::good, "ok"}, {Fitness::unknown, "?"}, {Fitness::bad, "BAD"}};
  int bad = 0;
  for (const Advice& advice : advices) {
    std::printf("%-4s %s\n", words.at(advice.fitness), error_line(advice.text).c_str());
    if (!advice.remedy.empty()) std::printf("       -> %s\n", error_line(advice.remedy).c_str());
    bad += advice.fitness == Fitness::bad ? 1 : 0;
  }
  std::printf("%zu looked at, %d bad\n", advices.size(), bad);
  return bad == 0 ? 0 : 1;
}

int examine(BringupOptions& bringup, bool clean) {
  Advices advices = judge_limits(read_sysctl, ::geteuid() == 0);
  advices.push_back(judge_shared_memory(clean));
  const auto add = [&](Advices more) {
    for (Advice& one : more) advices.push_back(std::move(one));
  };
  add(judge_upgrade(running_programs()));
  if (bringup.file.empty()) return print(advices);
  bringup.locate();
  const auto deployment = load_deployment(bringup.file, bringup.overrides);
  if (deployment.radio) {
    add(judge_radio(read_sysctl, ::geteuid() == 0, error_of_opening("/dev/net/tun")));
  }
  add(judge_equipment(deployment, own_equipment()));
  return print(advices);
}

}  // namespace
}  // namespace tocsin::doctor

int main(int argc, char** argv) {
  CLI::App app{"Is this computer fit to run the stack? With FILE: its radio and devices, too",
               "tocsin doctor"};
  tocsin::BringupOptions bringup;
  bool clean = false;
  bringup.declare(app);
  app.get_option("FILE")->required(false);
  app.add_flag("--clean", clean, "remove shared memory that dead processes have left");
  return tocsin::run_command(app, argc, argv,
                             [&] { return tocsin::doctor::examine(bringup, clean); });
}
