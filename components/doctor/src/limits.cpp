// SPDX-License-Identifier: Apache-2.0
#include "limits.hpp"

#include <sstream>

namespace tocsin::doctor {
namespace {

/// A burst of pictures of 60 kB at several readers; Linux's usual 208 KiB hold three of them.
constexpr long wanted_buffer_bytes = 1 << 20;

Advice judge_buffer(const std::string& name, const ReadSysctl& read) {
  const auto text = read(name);
  if (!text) return {Verdict::unknown, name + " cannot be read here", ""};
  const long bytes = std::strtol(text->c_str(), nullptr, 10);
  const std::string found = name + " = " + std::to_string(bytes);
  if (bytes >= wanted_buffer_bytes) return {Verdict::good, found, ""};
  return {Verdict::bad, found + ": large samples may be lost in the socket, 1048576 are advised",
          "sysctl -w " + name + "=1048576"};
}

Advice judge_ping(const ReadSysctl& read, bool root) {
  if (root) return {Verdict::good, "echo requests: root may send them", ""};
  const std::string name = "net.ipv4.ping_group_range";
  const auto text = read(name);
  if (!text) return {Verdict::unknown, name + " cannot be read here", ""};
  std::istringstream words(*text);
  long first = 1;
  long last = 0;
  words >> first >> last;
  if (first <= last) return {Verdict::good, "echo requests need no privileges", ""};
  return {Verdict::bad, name + " is empty: network_monitor needs root to send echo requests",
          "sysctl -w net.ipv4.ping_group_range='0 2147483647'"};
}

}  // namespace

Advices judge_limits(const ReadSysctl& read, bool root) {
  return {judge_buffer("net.core.rmem_max", read), judge_buffer("net.core.wmem_max", read),
          judge_ping(read, root)};
}

}  // namespace tocsin::doctor
