// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "foundation/time.hpp"
#include "vda5050_gateway/gateway.hpp"

namespace tocsin::vda5050 {

/// What is published on the broker.
struct Message {
  std::string topic;
  std::string payload;
  bool is_retained = false;
  int qos = 0;
};

/// The bodies of messages, without their header.
[[nodiscard]] nlohmann::json state_body(const Gateway& gateway, const Vehicle& vehicle);
[[nodiscard]] nlohmann::json visualization_body(const Gateway& gateway, const Vehicle& vehicle);
[[nodiscard]] nlohmann::json factsheet_body(const Identity& identity,
                                            const Capabilities& capabilities);

/// When which message of a vehicle is due. Pure.
///
/// A state is due at each change of it but of what changes all the time (position, battery, the
/// link's figures), when fleet control asks, and once in `state_period_s`; two are apart by
/// `least_apart_s`. Of a vehicle that was never heard there is none. When the vehicle is silent the
/// connection is told as broken, though the broker hears the gateway.
class Publications {
 public:
  struct Params {
    double state_period_s = 30;         ///< the standard's most
    double visualization_period_s = 1;  ///< 0: none
  };
  static constexpr double least_apart_s = 0.2;

  Publications(const Identity& identity, const Params& params)
      : identity_(identity), params_(params) {}

  /// The last will of the connection to the broker.
  [[nodiscard]] Message will(std::int64_t wall_ns);
  /// The connection to the broker was made, again: everything is due.
  void on_connected();
  /// What is to be published now.
  [[nodiscard]] std::vector<Message> due(Gateway& gateway, const Vehicle& vehicle, Time now,
                                         std::int64_t wall_ns);
  /// Before the connection is closed.
  [[nodiscard]] Message farewell(std::int64_t wall_ns);

 private:
  [[nodiscard]] Message make(const std::string& topic, nlohmann::json body, std::int64_t wall_ns);
  [[nodiscard]] Message connection(const char* state, std::int64_t wall_ns);
  [[nodiscard]] std::optional<Message> state(Gateway& gateway, const Vehicle& vehicle, Time now,
                                             std::int64_t wall_ns);

  Identity identity_;
  Params params_;
  std::map<std::string, std::uint32_t> headers_;  // next number of each topic
  std::optional<bool> told_heard_;
  bool was_heard_ = false;
  std::uint32_t state_header_ = 0;  // of the last state
  bool wants_factsheet_ = true;
  bool wants_state_ = true;
  nlohmann::json told_;  // what a change is seen by
  Time next_state_{};
  Time last_state_{};
  Time next_visualization_{};
};

}  // namespace tocsin::vda5050
