// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "operator_server/host_picture.hpp"
#include "operator_server/hub.hpp"
#include "runtime/service_port.hpp"

namespace tocsin::foxglove {

/// The calling end of a service that is known at run time only.
class AnyClient : public ClientPort {
 public:
  using ClientPort::call_message;
  using ClientPort::ClientPort;
  using ClientPort::Outcome;
  using ClientPort::take_outcome;
};

/// Services that clients call. An end is there while calls are under way and a little longer.
class ServiceCalls {
 public:
  /// A call that nobody answers for `patience` has failed.
  ServiceCalls(Component& owner, Duration patience) : owner_(owner), patience_(patience) {}

  void set_services(const std::vector<SeenService>& services);
  /// Asks, or tells the client why not.
  void call(const AskService& order, Hub& hub, Time now);
  /// Hands what came of calls to the hub.
  void take(Hub& hub, Time now);

 private:
  struct Caller {
    SeenService service;
    std::unique_ptr<AnyClient> client;
    std::map<CallNumber, AskService> pending = {};
    Time last_used{};
  };
  static void answer(const Caller& caller, const AskService& order,
                     const std::shared_ptr<const void>& response, Hub& hub);

  Component& owner_;
  const Duration patience_;
  std::map<std::string, SeenService> services_;
  std::map<std::string, Caller> callers_;
};

}  // namespace tocsin::foxglove
