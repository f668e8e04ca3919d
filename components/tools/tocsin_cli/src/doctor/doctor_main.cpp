// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "clock_offset.hpp"
#include "command_line/bringup_options.hpp"
#include "command_line/command.hpp"
#include "domain_ports.hpp"
#include "foundation/error.hpp"
#include "foundation/file_descriptor.hpp"
#include "interfaces.hpp"
#include "keystore/enclave.hpp"
#include "leftovers.hpp"
#include "limits.hpp"

namespace tocsin::doctor {
namespace {

std::optional<std::string> read_file(const std::string& path) {
  std::ifstream file(path);
  if (!file) return std::nullopt;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::optional<std::string> read_sysctl(std::string name) {
  for (char& c : name) c = c == '.' ? '/' : c;
  return read_file("/proc/sys/" + name);
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

Advice judge_domain(const std::string& what, int domain, const std::set<int>& ports) {
  const int count = participants(ports, domain);
  return {Fitness::good,
          "domain " + std::to_string(domain) + " (" + what + "): " + std::to_string(count) +
              " participants here",
          ""};
}

/// Of a host that has its identity here.
Advice judge_identity(const std::string& enclave) {
  const auto problems = keystore::problems_of(enclave, std::time(nullptr));
  if (problems.empty()) return {Fitness::good, "identity " + enclave + ": sound", ""};
  return {Fitness::bad, problems.front(), "tocsin keystore check"};
}

void examine(const deployment::Deployment& deployment, Advices& advices) {
  const auto here = interfaces();
  const std::set<int> ports = udp_ports(read_file("/proc/net/udp").value_or(""));
  for (const deployment::Host& host : deployment.hosts) {
    const std::string enclave = enclave_of(deployment, host);
    if (std::filesystem::is_directory(enclave)) advices.push_back(judge_identity(enclave));
    advices.push_back(judge_address(host.address, here));
    advices.push_back(judge_domain(host.name, host.local_domain, ports));
    if (advices[advices.size() - 2].fitness == Fitness::unknown) continue;
    for (const std::string& peer : host.peers) advices.push_back(compare_clock(peer));
  }
  advices.push_back(judge_domain("link", deployment.link_domain, ports));
  if (!deployment.radio) return;
  for (Advice& one : judge_radio(read_sysctl, ::geteuid() == 0, error_of_opening("/dev/net/tun"))) {
    advices.push_back(std::move(one));
  }
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
  advices.push_back(judge_loopback(interfaces()));
  advices.push_back(judge_shared_memory(clean));
  if (!bringup.file.empty()) {
    bringup.locate();
    examine(load_deployment(bringup.file, bringup.overrides), advices);
  }
  return print(advices);
}

}  // namespace
}  // namespace tocsin::doctor

int main(int argc, char** argv) {
  CLI::App app{"Is this computer fit to run the stack? With FILE: its addresses, peers, clocks",
               "tocsin doctor"};
  tocsin::BringupOptions bringup;
  bool clean = false;
  bringup.declare(app);
  app.get_option("FILE")->required(false);
  app.add_flag("--clean", clean, "remove shared memory that dead processes have left");
  return tocsin::run_command(app, argc, argv,
                             [&] { return tocsin::doctor::examine(bringup, clean); });
}
