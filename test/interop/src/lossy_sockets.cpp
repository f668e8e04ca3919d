// SPDX-License-Identifier: Apache-2.0
// $INTEROP_LOSS of 100 UDP packets that this process sends, and as many of those that it receives,
// are lost. The C library's functions are replaced for all that is linked with them, so that every
// maker's participant loses the same way, and no kernel module is needed. Which ones: by a hash of
// their number, the same in each run.
#include <dlfcn.h>
#include <sys/socket.h>

#include <atomic>
#include <cstdint>
#include <cstdlib>

namespace {

unsigned loss_percent() {
  static const unsigned percent = [] {
    const char* const text = std::getenv("INTEROP_LOSS");
    return text == nullptr ? 0U : static_cast<unsigned>(std::atoi(text));
  }();
  return percent;
}

/// The mixer of SplitMix64 (Steele, Lea and Flood 2014), so that neighbours differ.
std::uint64_t mixed(std::uint64_t number) {
  number = (number ^ (number >> 30U)) * 0xBF58476D1CE4E5B9U;
  number = (number ^ (number >> 27U)) * 0x94D049BB133111EBU;
  return number ^ (number >> 31U);
}

bool is_lost() {
  static std::atomic<std::uint64_t> packets{0};
  return mixed(++packets * 0x9E3779B97F4A7C15U) % 100 < loss_percent();
}

bool is_udp(const void* address) {
  return address != nullptr && static_cast<const sockaddr*>(address)->sa_family == AF_INET;
}

std::size_t size_of(const msghdr& message) {
  std::size_t bytes = 0;
  for (std::size_t i = 0; i < message.msg_iovlen; ++i) bytes += message.msg_iov[i].iov_len;
  return bytes;
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

/// What is received is no RTPS any more: whoever reads it ignores it.
void lose(void* data) { *static_cast<char*>(data) = 0; }

}  // namespace

extern "C" {

ssize_t sendmsg(int socket, const msghdr* message, int flags) {
  static auto* const real = next<decltype(sendmsg)>("sendmsg");
  if (is_udp(message->msg_name) && is_lost()) return static_cast<ssize_t>(size_of(*message));
  return real(socket, message, flags);
}

// NOLINTBEGIN(readability-function-size): the parameters are those of POSIX.
ssize_t sendto(int socket, const void* data, std::size_t bytes, int flags, const sockaddr* to,
               socklen_t to_bytes) {
  static auto* const real = next<decltype(sendto)>("sendto");
  if (is_udp(to) && is_lost()) return static_cast<ssize_t>(bytes);
  return real(socket, data, bytes, flags, to, to_bytes);
}

ssize_t recvmsg(int socket, msghdr* message, int flags) {
  static auto* const real = next<decltype(recvmsg)>("recvmsg");
  const ssize_t bytes = real(socket, message, flags);
  if (bytes > 0 && is_udp(message->msg_name) && is_lost()) lose(message->msg_iov[0].iov_base);
  return bytes;
}

ssize_t recvfrom(int socket, void* data, std::size_t most, int flags, sockaddr* from,
                 socklen_t* from_bytes) {
  static auto* const real = next<decltype(recvfrom)>("recvfrom");
  const ssize_t bytes = real(socket, data, most, flags, from, from_bytes);
  if (bytes > 0 && is_udp(from) && is_lost()) lose(data);
  return bytes;
}

// NOLINTEND(readability-function-size)

}  // extern "C"
