// SPDX-License-Identifier: Apache-2.0
#include "tun.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <linux/if_tun.h>
#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "foundation/error.hpp"

namespace tocsin::link {
namespace {

std::string reason() { return std::strerror(errno); }

FileDescriptor open_namespace(const std::string& path) {
  FileDescriptor fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!fd) throw ConfigError("network namespace " + path + ": " + reason());
  return fd;
}

/// Stays in another network namespace as long as it lives.
class NamespaceVisit {
 public:
  explicit NamespaceVisit(const std::string& path) : home_(open_namespace("/proc/self/ns/net")) {
    const FileDescriptor target = open_namespace(path);
    if (::setns(target.get(), CLONE_NEWNET) == 0) return;
    if (errno == EINVAL) {
      throw ConfigError(path + " is not a network namespace");
    }
    throw EnvironmentError("needs CAP_SYS_ADMIN to enter " + path +
                           " (run as root or inside a user namespace): " + reason());
  }
  ~NamespaceVisit() {
    if (::setns(home_.get(), CLONE_NEWNET) != 0) std::abort();
  }
  NamespaceVisit(const NamespaceVisit&) = delete;
  NamespaceVisit& operator=(const NamespaceVisit&) = delete;

 private:
  FileDescriptor home_;
};

FileDescriptor attach(const std::string& interface) {
  FileDescriptor fd(::open("/dev/net/tun", O_RDWR | O_CLOEXEC | O_NONBLOCK));
  if (!fd) {
    throw EnvironmentError("needs /dev/net/tun to carry packets: " + reason());
  }
  ifreq request{};
  interface.copy(request.ifr_name, IFNAMSIZ - 1);
  request.ifr_flags = IFF_TUN | IFF_NO_PI;
  if (::ioctl(fd.get(), TUNSETIFF, &request) != 0) {
    throw EnvironmentError("needs CAP_NET_ADMIN to make the interface " + interface +
                           ", and no other process on it: " + reason());
  }
  if (::ioctl(fd.get(), TUNSETPERSIST, 1) != 0) {
    throw EnvironmentError("cannot make " + interface + " persistent: " + reason());
  }
  return fd;
}

/// Sets properties of an interface of the current namespace.
class InterfaceSetup {
 public:
  explicit InterfaceSetup(const std::string& interface)
      : interface_(interface), socket_(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0)) {
    interface.copy(request_.ifr_name, IFNAMSIZ - 1);
  }
  void address(unsigned long request, in_addr address) {
    sockaddr_in value{};
    value.sin_family = AF_INET;
    value.sin_addr = address;
    std::memcpy(&request_.ifr_addr, &value, sizeof value);
    apply(request, "address");
  }
  void mtu(int bytes) {
    request_.ifr_mtu = bytes;
    apply(SIOCSIFMTU, "MTU");
  }
  void up() {
    request_.ifr_flags = IFF_UP | IFF_RUNNING | IFF_MULTICAST | IFF_NOARP | IFF_POINTOPOINT;
    apply(SIOCSIFFLAGS, "flags");
  }

 private:
  void apply(unsigned long request, const char* what) {
    if (::ioctl(socket_.get(), request, &request_) == 0) return;
    throw EnvironmentError("cannot set the " + std::string(what) + " of " + interface_ + ": " +
                           reason());
  }

  std::string interface_;
  FileDescriptor socket_;
  ifreq request_{};
};

/// The link is an IPv4 link: router solicitations would only load it and its counters. Where /proc
/// is read-only they stay, which does no harm.
void silence_ipv6(const std::string& interface) {
  const std::string path = "/proc/sys/net/ipv6/conf/" + interface + "/disable_ipv6";
  std::ofstream(path) << 1;
}

void set_up(const std::string& interface, const End& end) {
  silence_ipv6(interface);
  InterfaceSetup setup(interface);
  in_addr address{};
  inet_pton(AF_INET, end.address.c_str(), &address);
  setup.address(SIOCSIFADDR, address);
  setup.address(SIOCSIFNETMASK, in_addr{htonl(~std::uint32_t{0} << (32 - end.prefix))});
  setup.mtu(link_mtu);
  setup.up();
}

}  // namespace

Tun::Tun(const End& end, const std::string& interface) {
  const NamespaceVisit visit(end.netns);
  fd_ = attach(interface);
  set_up(interface, end);
}

std::vector<std::uint8_t> Tun::read() {
  std::uint8_t buffer[link_mtu + 100];
  const ssize_t count = ::read(fd_.get(), buffer, sizeof buffer);
  if (count < 0 && errno == EBADFD) gone_ = true;
  if (count <= 0) return {};
  return {buffer, buffer + count};
}

bool Tun::write(const std::vector<std::uint8_t>& packet) {
  return ::write(fd_.get(), packet.data(), packet.size()) == static_cast<ssize_t>(packet.size());
}

void Tun::remove_at_end() { (void)::ioctl(fd_.get(), TUNSETPERSIST, 0); }

bool is_group_addressed(const std::vector<std::uint8_t>& packet, int prefix) {
  if (packet.size() >= 40 && packet[0] >> 4 == 6) return packet[24] == 0xff;
  if (packet.size() < 20 || packet[0] >> 4 != 4) return false;
  std::uint32_t to = 0;
  std::memcpy(&to, &packet[16], sizeof to);
  to = ntohl(to);
  const std::uint32_t hosts = ~std::uint32_t{0} >> prefix;
  return to >> 28 == 0xe || (to & hosts) == hosts;
}

std::uint32_t destination_of(const std::vector<std::uint8_t>& packet) {
  std::uint32_t to = 0;
  if (packet.size() >= 20 && packet[0] >> 4 == 4) std::memcpy(&to, &packet[16], sizeof to);
  return to;
}

std::uint8_t dscp_of(const std::vector<std::uint8_t>& packet) {
  const int version = packet.size() >= 20 ? packet[0] >> 4 : 0;
  if (version == 4) return static_cast<std::uint8_t>(packet[1] >> 2);
  if (version != 6) return 0;
  return static_cast<std::uint8_t>((packet[0] & 0x0f) << 2 | packet[1] >> 6);
}

}  // namespace tocsin::link
