// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "runtime/detail/services.hpp"

namespace tocsin {

/// Services between the components of one bus in memory. One thread; it must outlive its ends.
class LocalServices {
 public:
  LocalServices();
  ~LocalServices();
  LocalServices(const LocalServices&) = delete;
  LocalServices& operator=(const LocalServices&) = delete;
  [[nodiscard]] std::unique_ptr<ServerEnd> serve(const ServiceEndpoint& endpoint,
                                                 ServerReceiver& receiver);
  [[nodiscard]] std::unique_ptr<ClientEnd> call(const ServiceEndpoint& endpoint,
                                                ClientReceiver& receiver);

  /// Names that somebody calls.
  [[nodiscard]] std::vector<std::string> called() const;

 private:
  class Server;
  class Client;
  struct Service {
    std::vector<ServerReceiver*> servers;  ///< the first one is asked
    std::map<std::int64_t, ClientReceiver*> clients;
  };
  void wake_clients(const std::string& name);
  std::map<std::string, Service> services_;
  std::int64_t last_client_ = 0;
};

}  // namespace tocsin
