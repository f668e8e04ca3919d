// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>

#include "foundation/time.hpp"
#include "operator_server/server_message.hpp"

namespace tocsin::foxglove {

/// Refuses missions of clients while another operator drives by hand.
///
/// A client is the operator under whose name it published last. Names are no secrets: this guards
/// operators from each other's mistakes. Pure; `now` must not decrease.
class MissionGuard {
 public:
  /// The vehicle repeats its report once a second while somebody drives; an older one does not
  /// count.
  static constexpr Duration counts_for = std::chrono::seconds(3);

  /// Whom the vehicle follows; empty: nobody.
  void on_driver(std::string name, Time now) { driver_ = {std::move(name), now}; }
  void on_operator(ClientId client, std::string name) { operators_[client] = std::move(name); }
  void forget(ClientId client) { operators_.erase(client); }
  /// Why the client may not call this service, as `/follow_waypoints/_action/send_goal`; empty: it
  /// may.
  [[nodiscard]] std::string refusal(ClientId client, const std::string& service, Time now) const;

 private:
  struct Driver {
    std::string name;
    Time reported{};
  };
  std::optional<Driver> driver_;
  std::map<ClientId, std::string> operators_;
};

}  // namespace tocsin::foxglove
