// SPDX-License-Identifier: Apache-2.0
#include "service_caller.hpp"

#include <algorithm>
#include <chrono>

#include "command_line/stop_signal.hpp"
#include "foundation/error.hpp"

namespace tocsin::topic_tool {

ServiceCaller::ServiceCaller(HostGraph& graph, const ServiceEndpoint& endpoint)
    : name_(service_name(endpoint)), end_(graph.call(endpoint, *this)) {}

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
  for (Duration waited{0}; waited < patience && !is_stopped(); waited += look) {
    if (changed_.wait_for(lock, std::min(look, patience - waited), done)) return true;
  }
  return done();
}

bool ServiceCaller::wait_for_server(Duration patience) {
  return wait(patience, [this] { return end_->available(); });
}

std::shared_ptr<const void> ServiceCaller::call(const std::shared_ptr<const void>& request,
                                                Duration patience) {
  if (!wait_for_server(patience)) throw EnvironmentError("service " + name_ + ": nobody serves it");
  const auto number = end_->send(request);
  const bool answered = number && wait(patience, [&] { return replies_.count(*number) != 0; });
  if (!answered) throw EnvironmentError("service " + name_ + ": no answer");
  const std::lock_guard<std::mutex> lock(mutex_);
  return replies_.at(*number);
}

}  // namespace tocsin::topic_tool
