// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/service_caller.hpp"

#include <algorithm>
#include <chrono>

#include "command_line/stop_signal.hpp"
#include "foundation/error.hpp"

namespace tocsin {

ServiceCaller::ServiceCaller(HostGraph& graph, const ServiceEndpoint& endpoint)
    : name_(service_name(endpoint)), end_(graph.call(endpoint, *this)) {}

ServiceCaller::ServiceCaller(Bus& bus, const ServiceEndpoint& endpoint)
    : name_(service_name(endpoint)), end_(bus.call(endpoint, *this)) {}

void ServiceCaller::receive(ServiceReply&& reply) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    replies_[reply.number] = std::move(reply.message);
  }
  changed_.notify_all();
}

template <class Condition>
bool ServiceCaller::wait(Duration patience, const Condition& done) {
  constexpr Duration look = std::chrono::milliseconds(50);  // a signal wakes nobody
  std::unique_lock<std::mutex> lock(mutex_);
  for (Duration waited{0}; waited < patience; waited += look) {
    if (is_stopped() && !outlasts_signals_) break;
    if (changed_.wait_for(lock, std::min(look, patience - waited), done)) return true;
  }
  return done();
}

bool ServiceCaller::wait_for_server(Duration patience) {
  return wait(patience, [this] { return end_->available(); });
}

void ServiceCaller::require(Duration patience) {
  if (!wait_for_server(patience)) throw EnvironmentError("service " + name_ + ": nobody serves it");
}

std::shared_ptr<const void> ServiceCaller::reply(std::int64_t number) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = replies_.find(number);
  return found != replies_.end() ? found->second : nullptr;
}

std::shared_ptr<const void> ServiceCaller::call(const std::shared_ptr<const void>& request,
                                                Duration patience) {
  require(patience);
  const auto number = end_->send(request);
  const bool answered = number && wait(patience, [&] { return replies_.count(*number) != 0; });
  if (!answered) throw EnvironmentError("service " + name_ + ": no answer");
  return reply(*number);
}

}  // namespace tocsin
