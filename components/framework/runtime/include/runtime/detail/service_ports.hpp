// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "runtime/component.hpp"
#include "runtime/detail/services.hpp"

namespace tocsin {

/// The serving end of a service without its C++ types: requests wait until the component's tick
/// takes them. Only newest `depth` are kept.
class ServerPort : private ServerReceiver {
 public:
  ServerPort(Component& owner, const ServiceEndpoint& endpoint);

  /// The oldest request that was not taken yet.
  [[nodiscard]] std::optional<ServiceRequest> take_request();
  void reply_message(const CallId& id, const std::shared_ptr<const void>& message);

 private:
  void receive(ServiceRequest&& request) override;
  void wake() override { owner_.schedule().input_arrived(); }
  Component& owner_;
  const std::size_t depth_;
  std::mutex mutex_;
  std::deque<ServiceRequest> requests_;
  std::unique_ptr<ServerEnd> end_;  // last: destroyed first; null: this bus has no services
};

/// Number of a call among those of one client.
using CallNumber = std::uint64_t;

/// The calling end of a service without its C++ types.
class ClientPort : private ClientReceiver {
 public:
  ClientPort(Component& owner, const ServiceEndpoint& endpoint);

  /// Whether somebody serves it.
  [[nodiscard]] bool available() const { return end_ != nullptr && end_->available(); }

 protected:
  struct Outcome {
    CallNumber call;
    std::shared_ptr<const void> message;
  };
  CallNumber call_message(std::shared_ptr<const void> message, Time deadline);
  [[nodiscard]] std::optional<Outcome> take_outcome(Time now);

 private:
  struct Pending {
    Time deadline;
    std::shared_ptr<const void> unsent;  ///< null once it is on its way
    std::optional<std::int64_t> number;
  };
  void receive(ServiceReply&& reply) override;
  void wake() override { owner_.schedule().input_arrived(); }
  void send_waiting();
  [[nodiscard]] std::optional<Outcome> next_answered();
  [[nodiscard]] std::optional<Outcome> next_expired(Time now);
  Component& owner_;
  std::mutex mutex_;
  std::deque<ServiceReply> replies_;
  CallNumber last_ = 0;
  std::map<CallNumber, Pending> pending_;
  std::unique_ptr<ClientEnd> end_;  // last: destroyed first
};

}  // namespace tocsin
