// SPDX-License-Identifier: Apache-2.0
// Sends hostile packets at all DDS participants of this network namespace and watches processes.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "storm.hpp"

namespace {

using namespace tocsin::fuzz;

/// Each of them alone, so that what it does can be seen.
std::vector<std::string> send_named(const Attacker& attacker, const Victims& victims,
                                    const std::vector<NamedPacket>& packets) {
  for (const NamedPacket& packet : packets) {
    attacker.send_to_all(packet.bytes);
    const auto complaints = victims.complaints();
    fmt::print("{:55} {}\n", packet.name, complaints.empty() ? "no effect" : complaints.front());
    if (!complaints.empty()) return complaints;
  }
  return {};
}

std::vector<std::string> attack(const Attacker& attacker, const Victims& victims,
                                const std::string& only, const StormSize& size) {
  std::vector<NamedPacket> anybody = hostile_from_anybody();
  std::vector<NamedPacket> announced = hostile_from_announced();
  for (auto* packets : {&anybody, &announced}) {
    std::vector<NamedPacket> wanted;
    for (const NamedPacket& packet : *packets) {
      if (packet.name.find(only) != std::string::npos) wanted.push_back(packet);
    }
    *packets = wanted;
  }
  if (auto complaints = send_named(attacker, victims, anybody); !complaints.empty()) {
    return complaints;
  }
  const auto others = attacker.announced_by_others(std::chrono::milliseconds(1500));
  fmt::print("announced; {} participants answered\n", others.size());
  if (auto complaints = send_named(attacker, victims, announced); !complaints.empty()) {
    return complaints;
  }
  send_storm(attacker, size);
  std::this_thread::sleep_for(std::chrono::seconds(2));
  return victims.complaints();
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<pid_t> processes;
  std::string only;
  StormSize size;
  CLI::App app("Sends hostile RTPS packets at all participants of this network namespace.");
  app.add_option("--pid", processes, "processes to watch")->required();
  app.add_option("--only", only, "named packets with this text only");
  app.add_option("--mutated", size.mutated, "mutated captures");
  app.add_option("--random", size.random, "random datagrams");
  app.add_option("--structured", size.structured, "known submessages with odd fields");
  app.add_option("--seed", size.seed, "of the storm");
  CLI11_PARSE(app, argc, argv);
  fmt::print("seed {}\n", size.seed);
  const Attacker attacker;
  const auto complaints = attack(attacker, Victims(processes), only, size);
  for (const std::string& complaint : complaints) fmt::print("{}\n", complaint);
  fmt::print("{}\n", complaints.empty() ? "all well" : "NOT well");
  return complaints.empty() ? 0 : 1;
}
