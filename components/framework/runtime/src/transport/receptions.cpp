// SPDX-License-Identifier: Apache-2.0
#include "transport/receptions.hpp"

#include <string>
#include <utility>

namespace tocsin {

void Receptions::open(std::uint32_t port) {
  const std::lock_guard<std::mutex> lock(mutex_);
  by_port_[port].activity =
      watched_activity(Duty::reception, "reception at UDP " + std::to_string(port),
                       static_cast<std::uint16_t>(port));
}

void Receptions::opened(std::uint32_t port) {
  auto socket = std::make_shared<const SocketWait>(static_cast<std::uint16_t>(port));
  const std::lock_guard<std::mutex> lock(mutex_);
  by_port_[port].socket = std::move(socket);
}

void Receptions::close(std::uint32_t port) {
  const std::lock_guard<std::mutex> lock(mutex_);
  by_port_.erase(port);
}

Reception Receptions::at(std::uint32_t port) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = by_port_.find(port);
  return found == by_port_.end() ? Reception{} : found->second;
}

}  // namespace tocsin
