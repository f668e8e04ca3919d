// SPDX-License-Identifier: Apache-2.0
#include "service_manager.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace tocsin::cli {
namespace {

/// The value of a variable, which the processes that this one starts do not inherit.
std::string taken(const char* variable) {
  const char* const value = std::getenv(variable);
  std::string text = value == nullptr ? "" : value;
  ::unsetenv(variable);
  return text;
}

}  // namespace

ServiceManager::ServiceManager() : address_(taken("NOTIFY_SOCKET")) {
  const std::string period = taken("WATCHDOG_USEC");
  const std::string asked = taken("WATCHDOG_PID");
  if (address_.empty() || address_.size() >= sizeof(sockaddr_un::sun_path)) return;
  socket_ = FileDescriptor(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
  const long long period_us = std::strtoll(period.c_str(), nullptr, 10);
  const bool is_for_this = asked.empty() || asked == std::to_string(::getpid());
  if (period_us <= 0 || !is_for_this) return;
  sign_period_ = std::chrono::microseconds(period_us) / 2;
  next_sign_ = Time{};
}

void ServiceManager::ready(const std::string& status) { send("READY=1\nSTATUS=" + status); }

void ServiceManager::stopping() { send("STOPPING=1"); }

void ServiceManager::alive(Time now) {
  if (now < next_sign_) return;
  next_sign_ = now + sign_period_;
  send("WATCHDOG=1");
}

void ServiceManager::send(const std::string& state) const {
  if (!socket_) return;
  sockaddr_un to{};
  to.sun_family = AF_UNIX;
  std::copy(address_.begin(), address_.end(), to.sun_path);
  if (to.sun_path[0] == '@') to.sun_path[0] = '\0';  // an abstract one
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + address_.size());
  // Whoever reads no more decides by its own watchdog.
  (void)::sendto(socket_.get(), state.data(), state.size(), MSG_NOSIGNAL,
                 reinterpret_cast<const sockaddr*>(&to), length);
}

}  // namespace tocsin::cli
