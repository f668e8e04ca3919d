// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "foundation/role.hpp"
#include "link_router/link_receiver.hpp"
#include "link_router/site_choice.hpp"
#include "runtime/logger.hpp"
#include "runtime/middleware/link_bus.hpp"

namespace tocsin {

/// Which peers count, where a vehicle has several sites. It hears all of them, and chooses; a site
/// hears from the vehicle which one that is, and lets go of a vehicle that speaks with another.
class SiteLink {
 public:
  /// All outlive it.
  SiteLink(LinkBus& link, router::LinkReceiver& receiver, Role role, Logger& log);
  /// What was received of the emergency stop tells who is there, and how old what it says is.
  void take(const StopNews& news, Time now);
  /// Of this host.
  [[nodiscard]] Role role() const { return role_; }
  /// The host of the site that this vehicle speaks with; empty when it has no choice.
  [[nodiscard]] std::string chosen() const { return choice_.chosen(); }
  /// What is to be told: the same; at a site, the other one that its vehicle speaks with, while the
  /// vehicle is received. Empty: nothing.
  [[nodiscard]] std::string to_tell(Time now) const;
  /// Whether this is a site, and its vehicle speaks with another one.
  [[nodiscard]] bool is_left() const { return !told_.empty() && told_ != host_; }

 private:
  void follow_choice(Time now);
  /// Values come out of order, since there are several sockets.
  [[nodiscard]] bool is_newest(const ReceivedStop& said);
  void follow_vehicle(const ReceivedStop& said);

  LinkBus& link_;
  router::LinkReceiver& receiver_;
  Logger& log_;
  const Role role_;
  router::SiteChoice choice_;
  std::map<std::string, std::uint64_t> numbers_;  ///< of the last value that counts, by its host
  const std::string host_;
  std::string told_;  ///< with whom the vehicle of this site speaks; empty when it has no choice
  Time told_at_{};
};

}  // namespace tocsin
