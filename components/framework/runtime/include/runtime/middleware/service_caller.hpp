// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "foundation/time.hpp"
#include "runtime/bus.hpp"
#include "runtime/middleware/host_graph.hpp"

namespace tocsin {

/// A service of a host as a command of a person calls it: waits for the answer, in real time, so it
/// is not for components.
class ServiceCaller : private ClientReceiver {
 public:
  ServiceCaller(HostGraph& graph, const ServiceEndpoint& endpoint);
  ServiceCaller(Bus& bus, const ServiceEndpoint& endpoint);

  /// Whether somebody serves it, at once or within `timeout`.
  [[nodiscard]] bool wait_for_server(Duration timeout);
  /// Throws EnvironmentError when nobody does.
  void require(Duration timeout);
  /// Throws EnvironmentError when nobody serves it, or nobody answers, within `timeout` each.
  [[nodiscard]] std::shared_ptr<const void> call(const std::shared_ptr<const void>& request,
                                                 Duration timeout);
  /// Asks without waiting; nothing when nobody serves it. `reply` has the answer once it is there.
  [[nodiscard]] std::optional<std::int64_t> send(const std::shared_ptr<const void>& request) {
    return end_->send(request);
  }
  [[nodiscard]] std::shared_ptr<const void> reply(std::int64_t number);
  /// From now on it waits although Ctrl-C was pressed: for what ends well what is under way.
  void outlast_signals() { outlasts_signals_ = true; }

 private:
  void receive(ServiceReply&& reply) override;
  void wake() override { changed_.notify_all(); }
  /// Until `done`, Ctrl-C or the end of `timeout`; what `done` says then.
  template <class Condition>
  bool wait(Duration timeout, const Condition& done);
  const std::string name_;
  bool outlasts_signals_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::int64_t, std::shared_ptr<const void>> replies_;  ///< by the number of the call
  std::unique_ptr<ClientEnd> end_;                               // last: destroyed first
};

/// Calls a service whose types are known here, of `node` when its name begins with ~: "/uxv/talker"
/// of a graph, "talker" in the namespace of a bus.
template <class Service, class Host>
std::shared_ptr<const typename Service::Response> call_service(Host& host, const std::string& node,
                                                               typename Service::Request request,
                                                               Duration timeout) {
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  ServiceCaller caller(host, {Service::name, &type_info<Request>(), &type_info<Response>(), node});
  return std::static_pointer_cast<const Response>(
      caller.call(std::make_shared<const Request>(std::move(request)), timeout));
}

}  // namespace tocsin
