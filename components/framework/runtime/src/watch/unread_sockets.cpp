// SPDX-License-Identifier: Apache-2.0
#include "watch/unread_sockets.hpp"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

namespace tocsin {
namespace {

constexpr int hexadecimal = 16;

/// The number after the colon in "0100007F:1CE8" or "00000000:00000300".
std::uint64_t after_colon(const std::string& word) {
  const std::size_t colon = word.find(':');
  if (colon == std::string::npos) return 0;
  return std::strtoull(word.c_str() + colon + 1, nullptr, hexadecimal);
}

/// Of the sockets among this process's descriptors, whose links are "socket:[12345]".
std::set<std::uint64_t> own_sockets() {
  std::set<std::uint64_t> inodes;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd", error)) {
    const std::string target = std::filesystem::read_symlink(entry.path(), error).string();
    constexpr const char* prefix = "socket:[";
    if (target.rfind(prefix, 0) != 0) continue;
    inodes.insert(
        std::strtoull(target.c_str() + std::char_traits<char>::length(prefix), nullptr, 10));
  }
  return inodes;
}

}  // namespace

std::set<std::uint16_t> unread_ports(std::istream& text, const std::set<std::uint64_t>& inodes) {
  std::set<std::uint16_t> ports;
  for (std::string line; std::getline(text, line);) {
    // "sl local rem st tx_queue:rx_queue tr:when retrnsmt uid timeout inode ..." (proc(5))
    std::istringstream words(line);
    std::string slot, local, remote, state, queues, timer, retransmits, user, timeout;
    std::uint64_t inode = 0;
    if (!(words >> slot >> local >> remote >> state >> queues >> timer >> retransmits >> user >>
          timeout >> inode)) {
      continue;
    }
    if (after_colon(queues) == 0 || inodes.count(inode) == 0) continue;
    ports.insert(static_cast<std::uint16_t>(after_colon(local)));
  }
  return ports;
}

std::set<std::uint16_t> unread_ports() {
  std::ifstream text("/proc/self/net/udp");
  return unread_ports(text, own_sockets());
}

}  // namespace tocsin
