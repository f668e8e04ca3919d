// SPDX-License-Identifier: Apache-2.0
#include "link/service_table.hpp"

#include <algorithm>
#include <utility>

#include "foundation/ros_names.hpp"

namespace tocsin {
namespace {

/// That wait for a router that does not look.
constexpr std::size_t most_waiting = 1024;

bool is_message(const HostServiceEvent& event) {
  return std::holds_alternative<host_service_event::Request>(event) ||
         std::holds_alternative<host_service_event::Reply>(event);
}

}  // namespace

ServiceTable::ServiceTable(const std::string& ros_namespace, std::function<void()> on_event)
    : prefix_(ros_namespace.empty() ? "/" : "/" + ros_namespace + "/"),
      on_event_(std::move(on_event)) {}

/// Servers are known by the writers of their replies, clients by those of their requests.
std::optional<ServiceTable::End> ServiceTable::end_in(const AnnouncedEnd& end) const {
  const auto service = ros_service(end.topic);
  if (!end.writer || !service || service->name.compare(0, prefix_.size(), prefix_) != 0) {
    return std::nullopt;
  }
  const Side side = service->half == ServiceHalf::reply ? Side::server : Side::client;
  return End{{service->name.substr(prefix_.size()), ros_service_type(end.type)}, side};
}

void ServiceTable::tell(const End& end, bool there) {
  const bool others = std::any_of(ends_.begin(), ends_.end(), [&](const auto& entry) {
    return entry.second.side == end.side && entry.second.what == end.what;
  });
  if (others) return;
  if (end.side == Side::server) {
    events_.push_back(host_service_event::Server{end.what, there});
  } else {
    events_.push_back(host_service_event::Client{end.what, there});
  }
}

void ServiceTable::on_end(const Guid& guid, const AnnouncedEnd& announced, bool there) {
  const auto end = end_in(announced);
  if (!end) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (there == (ends_.count(guid) != 0)) return;  // announced again, or never known
    ends_.erase(guid);
    tell(*end, there);
    if (there) ends_.emplace(guid, *end);
  }
  on_event_();
}

void ServiceTable::push(HostServiceEvent event) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (events_.size() >= most_waiting && is_message(event)) return;
    events_.push_back(std::move(event));
  }
  on_event_();
}

std::optional<HostServiceEvent> ServiceTable::pop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (events_.empty()) return std::nullopt;
  HostServiceEvent event = std::move(events_.front());
  events_.pop_front();
  return event;
}

}  // namespace tocsin
