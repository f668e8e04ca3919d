// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "vda5050_gateway/messages.hpp"

namespace tocsin::vda5050 {

/// A connection to a broker, which it keeps up: what is published, and what comes.
class Broker {
 public:
  struct Received {
    std::string topic;
    std::string payload;
  };
  virtual ~Broker() = default;
  /// How often it was connected; another number: anew since. Messages before may be lost.
  [[nodiscard]] virtual std::uint64_t connections() const = 0;
  [[nodiscard]] virtual bool is_connected() const = 0;
  /// Never blocks. False: it is lost.
  virtual bool publish(const Message& message) = 0;
  /// The oldest message that was not taken yet.
  [[nodiscard]] virtual std::optional<Received> take() = 0;
  /// Why it is not connected, for the log; empty: it is, or was never tried.
  [[nodiscard]] virtual std::string trouble() const = 0;
};

/// Where a broker is, and who we are to it.
struct BrokerAddress {
  std::string host = "127.0.0.1";
  std::uint16_t port = 1883;
  std::string client_id;
  std::string user;              ///< empty: without a name
  std::string password_file;     ///< its first line; empty: without
  std::string ca_file;           ///< PEM; empty: without TLS
  std::string certificate_file;  ///< PEM; empty: the broker asks for none
  std::string key_file;
};

/// Throws ConfigError naming the parameter and the file that cannot be read.
void check_files(const BrokerAddress& address);

/// MQTT 3.1.1 by libmosquitto, on a thread of its own. It connects by and by, and again where the
/// broker has gone. `subscriptions`: topics, with QoS 0. Throws ConfigError when a
/// file cannot be read.
[[nodiscard]] std::unique_ptr<Broker> connect_mqtt(const BrokerAddress& address,
                                                   const Message& will,
                                                   std::vector<std::string> subscriptions);

/// How a component comes to its broker; tests give another one.
using Connect = std::function<std::unique_ptr<Broker>(const BrokerAddress&, const Message&,
                                                      std::vector<std::string>)>;

}  // namespace tocsin::vda5050
