// SPDX-License-Identifier: Apache-2.0
#include "network.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/mount.h>
#include <sys/socket.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <thread>

#include "foundation/error.hpp"

namespace tocsin::cli {
namespace {

std::string reason() { return std::system_category().message(errno); }

[[noreturn]] void fail(const std::string& what) {
  throw EnvironmentError("radio: " + what + ": " + reason());
}

bool write_file(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  file.close();
  return static_cast<bool>(file);
}

void require_tun() {
  const FileDescriptor tun(::open("/dev/net/tun", O_RDWR | O_CLOEXEC));
  if (!tun) fail("needs /dev/net/tun to carry packets over the emulated link");
}

/// Root of a user namespace of its own, as which it owns the namespaces made from now on.
void become_root_of_user_namespace() {
  const std::string uid = std::to_string(::getuid());
  const std::string gid = std::to_string(::getgid());
  if (::unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) {
    fail("needs root, or user namespaces for everybody, to give each host a network of its own");
  }
  if (!write_file("/proc/self/setgroups", "deny") ||
      !write_file("/proc/self/uid_map", "0 " + uid + " 1") ||
      !write_file("/proc/self/gid_map", "0 " + gid + " 1")) {
    fail("cannot become root of a new user namespace");
  }
}

void set_up_loopback(int socket) {
  ifreq request{};
  std::strncpy(request.ifr_name, "lo", IFNAMSIZ - 1);
  request.ifr_flags = IFF_UP | IFF_RUNNING;
  if (::ioctl(socket, SIOCSIFFLAGS, &request) != 0) fail("cannot set the loopback up");
}

/// In a user namespace only group 0 exists.
void allow_echo_sockets() {
  const char* file = "/proc/sys/net/ipv4/ping_group_range";
  if (!write_file(file, "0 2147483647") && !write_file(file, "0 0")) fail("cannot allow ICMP echo");
}

}  // namespace

void enter_private_world() {
  require_tun();
  if (::unshare(CLONE_NEWNS) != 0) become_root_of_user_namespace();
  if (::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
      ::mount("tmpfs", "/dev/shm", "tmpfs", MS_NOSUID | MS_NODEV, "mode=1777") != 0) {
    fail("cannot give the run a /dev/shm of its own");
  }
}

HostNetwork::HostNetwork() {
  std::exception_ptr failure;
  // A thread's own namespace, so that the launcher never leaves its own: without privileges it
  // could not come back.
  std::thread maker([&] {
    try {
      if (::unshare(CLONE_NEWNET) != 0) fail("cannot make a network namespace");
      namespace_ = FileDescriptor(::open("/proc/thread-self/ns/net", O_RDONLY | O_CLOEXEC));
      socket_ = FileDescriptor(::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
      if (!namespace_ || !socket_) fail("cannot open the network namespace");
      set_up_loopback(socket_.get());
      allow_echo_sockets();
    } catch (const EnvironmentError&) {
      failure = std::current_exception();
    }
  });
  maker.join();
  if (failure) std::rethrow_exception(failure);
}

bool HostNetwork::has_link(const std::string& address) const {
  ifreq request{};
  std::strncpy(request.ifr_name, "wlan0", IFNAMSIZ - 1);
  if (::ioctl(socket_.get(), SIOCGIFFLAGS, &request) != 0) return false;
  if ((request.ifr_flags & IFF_UP) == 0 || (request.ifr_flags & IFF_RUNNING) == 0) return false;
  if (::ioctl(socket_.get(), SIOCGIFADDR, &request) != 0) return false;
  sockaddr_in found{};
  std::memcpy(&found, &request.ifr_addr, sizeof found);
  in_addr wanted{};
  return ::inet_pton(AF_INET, address.c_str(), &wanted) == 1 &&
         wanted.s_addr == found.sin_addr.s_addr;
}

}  // namespace tocsin::cli
