// SPDX-License-Identifier: Apache-2.0
#include "operator_server/service_calls.hpp"

#include <utility>

#include "idl_support/encode.hpp"
#include "operator_server/message_json.hpp"
#include "runtime/host_control.hpp"

namespace tocsin::foxglove {
namespace {

constexpr std::size_t most_pending = 100;  ///< calls of a service
constexpr Duration client_kept_for = std::chrono::seconds(30);

SharedBytes encoded(const TypeInfo& type, const void* message, const std::string& encoding) {
  if (encoding != "json") {
    return std::make_shared<const std::vector<std::uint8_t>>(encode(type, message));
  }
  const std::string text =
      json_of(type, message).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return std::make_shared<const std::vector<std::uint8_t>>(text.begin(), text.end());
}

}  // namespace

void ServiceCalls::set_services(const std::vector<SeenService>& services) {
  services_.clear();
  for (const SeenService& service : services) services_.emplace(service.name, service);
}

void ServiceCalls::call(const AskService& order, Hub& hub, Time now) {
  const auto service = services_.find(order.name);
  if (service == services_.end()) return hub.fail_service(order.client, order.call, "it has gone");
  const SeenService& seen = service->second;
  const MadeMessage request = message_from(*seen.request, order.call.encoding, order.call.payload);
  if (request.message == nullptr) {
    return hub.fail_service(order.client, order.call, request.fault);
  }
  auto caller = callers_.find(order.name);
  if (caller == callers_.end()) {
    const std::string name = bus_name(order.name, owner_.bus().host_control().ros_namespace());
    auto client = std::make_unique<AnyClient>(
        owner_, ServiceEndpoint{name, seen.request, seen.response, owner_.node()});
    caller = callers_.emplace(order.name, Caller{seen, std::move(client)}).first;
  }
  if (caller->second.pending.size() >= most_pending) {
    return hub.fail_service(order.client, order.call, "too many calls are under way");
  }
  caller->second.last_used = now;
  const CallNumber number = caller->second.client->call_message(request.message, now + patience_);
  caller->second.pending.emplace(number, order);
}

void ServiceCalls::take(Hub& hub, Time now) {
  for (auto one = callers_.begin(); one != callers_.end();) {
    Caller& caller = one->second;
    while (const auto outcome = caller.client->take_outcome(now)) {
      const auto pending = caller.pending.find(outcome->call);
      if (pending == caller.pending.end()) continue;
      answer(caller, pending->second, outcome->message, hub);
      caller.pending.erase(pending);
    }
    const bool stays = !caller.pending.empty() || now - caller.last_used < client_kept_for;
    one = stays ? std::next(one) : callers_.erase(one);
  }
}

void ServiceCalls::answer(const Caller& caller, const AskService& order,
                          const std::shared_ptr<const void>& response, Hub& hub) {
  if (response == nullptr) {
    return hub.fail_service(order.client, order.call, "nobody answered in time");
  }
  hub.answer_service(order.client, order.call,
                     encoded(*caller.service.response, response.get(), order.call.encoding));
}

}  // namespace tocsin::foxglove
