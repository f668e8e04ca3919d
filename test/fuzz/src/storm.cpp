// SPDX-License-Identifier: Apache-2.0
#include "storm.hpp"

#include <chrono>
#include <random>
#include <thread>

namespace tocsin::fuzz {
namespace {

constexpr double mib = 1024.0 * 1024.0;

/// Whether a thread of a process runs, or waits for a core, more than 0.3 s of each second for
/// longer than jumping numbers may cost (rtps_filter's `jump_cpu_s`, 4 s) while others need the
/// core, too.
bool spins(pid_t process) {
  constexpr double most_s = 0.3;
  constexpr int periods = 15;
  for (int period = 0; period < periods; ++period) {
    const Vitals begin = vitals_of(process).value_or(Vitals{});
    std::this_thread::sleep_for(std::chrono::seconds(1));
    const auto end = vitals_of(process, begin);
    if (!end || end->busiest_thread_s <= most_s) return false;
  }
  return true;
}

}  // namespace

void send_storm(const Attacker& attacker, const StormSize& size) {
  constexpr int at_once = 50;
  constexpr int to_one = 25;  // what one says may make what the next one does worse
  std::mt19937 random(size.seed);
  const std::vector<Packet>& captures = captured_packets();
  StormSize left = size;
  std::size_t target = 0;
  for (std::uint64_t sent = 1; left.mutated + left.random + left.structured > 0; ++sent) {
    const std::uint64_t all = std::uint64_t{left.mutated} + left.random + left.structured;
    const std::uint64_t drawn = random() % all;
    Packet packet;
    if (drawn < left.mutated) {
      --left.mutated;
      packet = captures[random() % captures.size()];
      mutate(packet, random);
    } else if (drawn < std::uint64_t{left.mutated} + left.random) {
      --left.random;
      packet = random_packet(random);
    } else {
      --left.structured;
      packet = structured_packet(random);
    }
    attacker.send_to_one(packet, target);
    if (sent % to_one == 0) target = random();
    // So that sockets do not drop what the victims should have to look at.
    if (sent % at_once == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

Victims::Victims(const std::vector<pid_t>& processes) {
  for (const pid_t process : processes) {
    before_.emplace_back(process, vitals_of(process).value_or(Vitals{}));
  }
}

std::vector<std::string> Victims::complaints() const {
  constexpr double most_growth = 64 * mib;
  std::vector<std::string> found;
  for (const auto& [process, before] : before_) {
    const std::string name = "process " + std::to_string(process);
    if (spins(process)) found.push_back(name + " has a thread that spins");
    const auto now = vitals_of(process);
    if (!now) {
      found.push_back(name + " died");
      continue;
    }
    const double growth =
        static_cast<double>(now->resident_bytes) - static_cast<double>(before.resident_bytes);
    if (growth > most_growth) found.push_back(name + " grew by " + std::to_string(growth / mib));
  }
  return found;
}

}  // namespace tocsin::fuzz
