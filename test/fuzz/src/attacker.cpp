// SPDX-License-Identifier: Apache-2.0
#include "attacker.hpp"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace tocsin::fuzz {
namespace {

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

/// Whether a task by its stat file is neither gone nor a corpse.
bool lives(const std::filesystem::path& task) {
  std::string text;
  if (!std::getline(std::ifstream(task / "stat"), text)) return false;
  std::istringstream words(text.substr(text.rfind(')') + 1));
  char state = 0;
  words >> state;
  return state != 'Z' && state != 'X';
}

/// How long a task has run or waited for a core [s]; nothing when it is gone. Errors:
/// std::runtime_error when the kernel does not count that.
std::optional<double> wanted_of(const std::filesystem::path& task) {
  std::ifstream file(task / "schedstat");  // proc(5)
  double ran_ns = 0;
  double waited_ns = 0;
  if (file >> ran_ns >> waited_ns) return 1e-9 * (ran_ns + waited_ns);
  if (lives(task)) throw std::runtime_error((task / "schedstat").string() + " cannot be read");
  return std::nullopt;
}

}  // namespace

std::vector<sockaddr_in> bound_addresses() {
  std::ifstream file("/proc/self/net/udp");
  std::string line;
  std::getline(file, line);
  std::set<std::pair<std::uint32_t, std::uint16_t>> seen;
  std::vector<sockaddr_in> found;
  while (std::getline(file, line)) {
    const std::size_t at = line.find(": ") + 2;  // address in the computer's byte order, port
    sockaddr_in one =
        loopback(static_cast<std::uint16_t>(std::stoul(line.substr(at + 9, 4), nullptr, 16)));
    const auto address = static_cast<std::uint32_t>(std::stoul(line.substr(at, 8), nullptr, 16));
    if (address != 0) one.sin_addr.s_addr = address;
    if (seen.emplace(one.sin_addr.s_addr, one.sin_port).second) found.push_back(one);
  }
  return found;
}

Attacker::Attacker(const std::string& address)
    : socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)), targets_(bound_addresses()) {
  sockaddr_in own{};
  own.sin_family = AF_INET;
  (void)inet_pton(AF_INET, address.c_str(), &own.sin_addr);
  socklen_t size = sizeof own;
  (void)::bind(socket_, reinterpret_cast<const sockaddr*>(&own), sizeof own);
  (void)getsockname(socket_, reinterpret_cast<sockaddr*>(&own), &size);
  port_ = ntohs(own.sin_port);
  const timeval patience{0, 20'000};
  setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
}

Attacker::~Attacker() { ::close(socket_); }

void Attacker::send_to_all(const Packet& packet) const {
  for (std::size_t i = 0; i < targets_.size(); ++i) send_to_one(packet, i);
}

void Attacker::send_to_one(const Packet& packet, std::size_t draw) const {
  const sockaddr_in& to = targets_[draw % targets_.size()];
  (void)::sendto(socket_, packet.data(), packet.size(), 0, reinterpret_cast<const sockaddr*>(&to),
                 sizeof to);
}

std::vector<Packet> Attacker::announced_by_others(std::chrono::milliseconds limit) const {
  return answers_to(hostile_announcement({{127, 0, 0, 1}, port_}), limit);
}

std::vector<Packet> Attacker::answers_to(const Packet& announcement,
                                         std::chrono::milliseconds limit) const {
  constexpr std::size_t prefix_at = 8;
  constexpr std::size_t prefix_bytes = 12;
  std::set<Packet> found;
  send_to_all(announcement);
  const auto end = std::chrono::steady_clock::now() + limit;
  while (std::chrono::steady_clock::now() < end) {
    std::array<std::uint8_t, 65536> bytes{};
    const ssize_t size = ::recv(socket_, bytes.data(), bytes.size(), 0);
    if (size < static_cast<ssize_t>(prefix_at + prefix_bytes)) continue;
    found.emplace(bytes.begin() + prefix_at, bytes.begin() + prefix_at + prefix_bytes);
  }
  return {found.begin(), found.end()};
}

std::optional<Vitals> vitals_of(pid_t process, const Vitals& before) {
  const std::filesystem::path folder = "/proc/" + std::to_string(process);
  if (!lives(folder)) return std::nullopt;
  Vitals vitals;
  std::uint64_t total = 0;
  std::uint64_t pages = 0;
  std::ifstream(folder / "statm") >> total >> pages;
  vitals.resident_bytes = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
  std::error_code gone;
  for (const auto& task : std::filesystem::directory_iterator(folder / "task", gone)) {
    const auto wanted_s = wanted_of(task.path());
    if (!wanted_s) continue;
    const int id = std::stoi(task.path().filename());
    double since = *wanted_s;
    for (const auto& [earlier, had_s] : before.threads) since -= earlier == id ? had_s : 0;
    vitals.threads.emplace_back(id, *wanted_s);
    vitals.busiest_thread_s = std::max(vitals.busiest_thread_s, since);
  }
  return vitals;
}

}  // namespace tocsin::fuzz
