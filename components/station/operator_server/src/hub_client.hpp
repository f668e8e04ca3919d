// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "operator_server/outbox.hpp"
#include "operator_server/user_role.hpp"

namespace tocsin::foxglove {

/// What the hub knows of one client.
class HubClient {
 public:
  HubClient(const OutboxLimits& limits, UserRole role_of_it) : outbox(limits), role(role_of_it) {}

  void fault(const std::string& text) { outbox.add_control(status(Level::error, text)); }
  [[nodiscard]] bool hears_parameter(const std::string& name) const {
    return all_parameters || parameters.count(name) != 0;
  }
  /// Ends the subscriptions to a channel.
  void forget_channel(std::uint32_t channel) {
    for (auto one = subscriptions.begin(); one != subscriptions.end();) {
      if (one->second != channel) {
        ++one;
        continue;
      }
      outbox.forget(one->first);
      one = subscriptions.erase(one);
    }
  }

  Outbox outbox;
  const UserRole role;
  std::map<std::uint32_t, std::uint32_t> subscriptions;  ///< channel by subscription
  std::map<std::uint32_t, ClientChannel> channels;       ///< that it publishes, by its own ids
  std::map<std::uint32_t, std::string> unheard;          ///< topics that nobody takes, by its ids
  std::set<std::string> told_unheard;                    ///< of which it was told so
  std::set<std::string> parameters;                      ///< whose changes it wants to hear
  bool all_parameters = false;
  bool hears_graph = false;
  bool was_slow = false;  ///< it has been told that it misses messages
};

}  // namespace tocsin::foxglove
