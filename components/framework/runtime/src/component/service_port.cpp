// SPDX-License-Identifier: Apache-2.0
#include "runtime/service_port.hpp"

#include <algorithm>

namespace tocsin {

std::string service_name(const ServiceEndpoint& endpoint) {
  const bool of_node = endpoint.name.compare(0, 2, "~/") == 0;
  return of_node ? endpoint.node + endpoint.name.substr(1) : endpoint.name;
}

ServerPort::ServerPort(Component& owner, const ServiceEndpoint& endpoint)
    : owner_(owner),
      depth_(static_cast<std::size_t>(endpoint.depth)),
      end_(owner.bus().serve(endpoint, *this)) {}

void ServerPort::receive(ServiceRequest&& request) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (requests_.size() == depth_) requests_.pop_front();
    requests_.push_back(std::move(request));
  }
  wake();
}

std::optional<ServiceRequest> ServerPort::take_request() {
  if (end_) end_->flush();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (requests_.empty()) return std::nullopt;
  ServiceRequest request = std::move(requests_.front());
  requests_.pop_front();
  return request;
}

void ServerPort::reply_message(const CallId& id, const std::shared_ptr<const void>& message) {
  if (end_) end_->reply(id, message);
}

ClientPort::ClientPort(Component& owner, const ServiceEndpoint& endpoint)
    : owner_(owner), end_(owner.bus().call(endpoint, *this)) {}

void ClientPort::receive(ServiceReply&& reply) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    replies_.push_back(std::move(reply));
  }
  wake();
}

CallNumber ClientPort::call_message(std::shared_ptr<const void> message, Time deadline) {
  pending_[++last_] = {deadline, std::move(message), std::nullopt};
  send_waiting();
  owner_.schedule().deadline = std::min(owner_.schedule().deadline, deadline);
  return last_;
}

void ClientPort::send_waiting() {
  for (auto& entry : pending_) {
    Pending& one = entry.second;
    if (!one.unsent || !end_) continue;
    one.number = end_->send(one.unsent);
    if (!one.number) return;
    one.unsent.reset();
  }
}

std::optional<ClientPort::Outcome> ClientPort::next_answered() {
  const std::lock_guard<std::mutex> lock(mutex_);
  while (!replies_.empty()) {
    const ServiceReply reply = std::move(replies_.front());
    replies_.pop_front();
    const auto asked = std::find_if(pending_.begin(), pending_.end(), [&](const auto& entry) {
      return entry.second.number == reply.number;
    });
    if (asked == pending_.end()) continue;  // it came too late
    const Outcome outcome{asked->first, reply.message};
    pending_.erase(asked);
    return outcome;
  }
  return std::nullopt;
}

std::optional<ClientPort::Outcome> ClientPort::next_expired(Time now) {
  for (auto it = pending_.begin(); it != pending_.end(); ++it) {
    if (it->second.deadline > now) continue;
    const Outcome outcome{it->first, nullptr};
    pending_.erase(it);
    return outcome;
  }
  return std::nullopt;
}

std::optional<ClientPort::Outcome> ClientPort::take_outcome(Time now) {
  send_waiting();
  auto outcome = next_answered();
  if (!outcome) outcome = next_expired(now);
  Time& next = owner_.schedule().deadline;
  for (const auto& entry : pending_) next = std::min(next, entry.second.deadline);
  return outcome;
}

}  // namespace tocsin
