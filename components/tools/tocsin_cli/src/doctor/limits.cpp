// SPDX-License-Identifier: Apache-2.0
#include "limits.hpp"

#include <cerrno>
#include <cstdlib>
#include <sstream>
#include <system_error>

namespace tocsin::doctor {
namespace {

/// A burst of pictures of 60 kB at several readers; Linux's usual 208 KiB hold three of them.
constexpr long wanted_buffer_bytes = 1 << 20;

Advice judge_buffer(const std::string& name, const ReadSysctl& read) {
  const auto text = read(name);
  if (!text) return {Fitness::unknown, name + " cannot be read here", ""};
  const long bytes = std::strtol(text->c_str(), nullptr, 10);
  const std::string found = name + " = " + std::to_string(bytes);
  if (bytes >= wanted_buffer_bytes) return {Fitness::good, found, ""};
  return {Fitness::bad, found + ": large samples may be lost in the socket, 1048576 are advised",
          "sysctl -w " + name + "=1048576"};
}

Advice judge_ping(const ReadSysctl& read, bool root) {
  if (root) return {Fitness::good, "echo requests: root may send them", ""};
  const std::string name = "net.ipv4.ping_group_range";
  const auto text = read(name);
  if (!text) return {Fitness::unknown, name + " cannot be read here", ""};
  std::istringstream words(*text);
  long first = 1;
  long last = 0;
  words >> first >> last;
  if (first <= last) return {Fitness::good, "echo requests need no privileges", ""};
  return {Fitness::bad, name + " is empty: network_monitor needs root to send echo requests",
          "sysctl -w net.ipv4.ping_group_range='0 2147483647'"};
}

Advice judge_tun(int error) {
  const std::string found = "/dev/net/tun (emulated radio): ";
  if (error == 0) return {Fitness::good, found + "can be opened", ""};
  const std::string remedy =
      error == ENOENT || error == ENXIO || error == ENODEV
          ? "modprobe tun; in a container: start it with --device /dev/net/tun"
          : "chmod 666 /dev/net/tun, or run as root";
  return {Fitness::bad, found + std::system_category().message(error), remedy};
}

/// Debian's switch, the kernel's own, and Ubuntu's; each is absent where it does not exist.
Advice judge_namespaces(const ReadSysctl& read, bool root) {
  if (root) return {Fitness::good, "network namespaces: root may make them", ""};
  struct Switch {
    const char* name;
    const char* off;
    const char* on;
  };
  for (const Switch& one : {Switch{"kernel.unprivileged_userns_clone", "0", "1"},
                            Switch{"user.max_user_namespaces", "0", "10000"},
                            Switch{"kernel.apparmor_restrict_unprivileged_userns", "1", "0"}}) {
    const auto text = read(one.name);
    if (!text || text->substr(0, text->find('\n')) != one.off) continue;
    return {Fitness::bad,
            std::string(one.name) + " = " + one.off +
                ": only root can give the hosts of an emulated radio networks of their own",
            std::string("sysctl -w ") + one.name + "=" + one.on};
  }
  return {Fitness::good, "network namespaces: everybody may make them", ""};
}

}  // namespace

Advices judge_limits(const ReadSysctl& read, bool root) {
  return {judge_buffer("net.core.rmem_max", read), judge_buffer("net.core.wmem_max", read),
          judge_ping(read, root)};
}

Advices judge_radio(const ReadSysctl& read, bool root, int tun_error) {
  return {judge_tun(tun_error), judge_namespaces(read, root)};
}

}  // namespace tocsin::doctor
