// SPDX-License-Identifier: Apache-2.0
#include "service_manager.hpp"

#include <unistd.h>

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
  if (address_.empty()) return;
  socket_.emplace();
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

void ServiceManager::send(const std::string& state) {
  // Whoever reads no more decides by its own watchdog.
  if (socket_) (void)socket_->send(address_, state);
}

}  // namespace tocsin::cli
