// SPDX-License-Identifier: Apache-2.0
#include "link_router/service_directory.hpp"

#include <algorithm>
#include <utility>

namespace tocsin::router {
namespace {

/// A container makes the servers of a node within some milliseconds after somebody calls one.
constexpr Duration own_host_first = std::chrono::milliseconds(500);

/// Of the services of a node, the one by which the peer's host learns that the node is there: ROS 2
/// looks for the node before it calls one.
bool names_its_node(const std::string& service) {
  static const std::string last = "/list_parameters";
  return service.size() > last.size() &&
         service.compare(service.size() - last.size(), last.size(), last) == 0;
}

bool has_name(const std::set<ServiceName>& services, const std::string& name) {
  return std::any_of(services.begin(), services.end(),
                     [&](const ServiceName& one) { return one.name == name; });
}

/// Without a second one of a name.
void add(std::set<ServiceName>& services, const ServiceName& one) {
  if (!has_name(services, one.name)) services.insert(one);
}

}  // namespace

void ServiceDirectory::on_server(const ServiceName& service, bool there) {
  changed_ = true;
  if (there) {
    servers_.insert(service);
  } else {
    servers_.erase(service);
  }
}

void ServiceDirectory::on_client(const ServiceName& service, bool there, Time now) {
  changed_ = true;
  if (there) {
    clients_.try_emplace(service, now);
  } else {
    clients_.erase(service);
  }
}

std::set<std::string> ServiceDirectory::on_peer(PeerInstance peer, const ServiceLists& lists) {
  changed_ = true;
  std::set<std::string> refused;
  ServiceLists& own = peers_[peer] = {};
  // What the file names goes before what a pattern takes.
  const auto take = [&](const auto& from, const auto& rule, std::set<ServiceName>& to) {
    for (const Crossing one : {Crossing::always, Crossing::on_demand, Crossing::no}) {
      for (const ServiceName& service : from) {
        if (rule(service.name) != one) continue;
        const bool taken = one != Crossing::no && to.size() < most_services;
        taken ? void(to.insert(service)) : void(refused.insert(service.name));
      }
    }
  };
  take(lists.offered, rules_.called, own.offered);
  take(lists.wanted, rules_.served, own.wanted);
  return refused;
}

void ServiceDirectory::forget_peer(PeerInstance peer) {
  changed_ = true;
  peers_.erase(peer);
}

bool ServiceDirectory::is_served_here(const std::string& name) const {
  return has_name(servers_, name);
}

bool ServiceDirectory::is_wanted_there(const std::string& name) const {
  return std::any_of(peers_.begin(), peers_.end(),
                     [&](const auto& peer) { return has_name(peer.second.wanted, name); });
}

bool ServiceDirectory::is_wanted_here(const std::string& name, Time now) const {
  return std::any_of(clients_.begin(), clients_.end(), [&](const auto& client) {
    return client.first.name == name && client.second + own_host_first <= now;
  });
}

ServiceLists ServiceDirectory::announced(Time now) const {
  ServiceLists lists;
  for (const ServiceName& server : servers_) {
    const Crossing crossing = rules_.served(server.name);
    const bool offered = crossing == Crossing::always ||
                         (crossing == Crossing::on_demand &&
                          (names_its_node(server.name) || is_wanted_there(server.name)));
    if (offered && lists.offered.size() < most_services) lists.offered.insert(server);
  }
  for (const auto& [client, since] : clients_) {
    const bool wanted = since + own_host_first <= now && !is_served_here(client.name) &&
                        rules_.called(client.name) != Crossing::no;
    if (wanted && lists.wanted.size() < most_services) lists.wanted.insert(client);
  }
  return lists;
}

std::set<ServiceName> ServiceDirectory::shown(Time now) const {
  std::set<ServiceName> services;
  for (const auto& [peer, lists] : peers_) {
    for (const ServiceName& offered : lists.offered) {
      const Crossing crossing = rules_.called(offered.name);
      const bool is_due = crossing == Crossing::always ||
                          (crossing == Crossing::on_demand && is_wanted_here(offered.name, now));
      if (is_due && !is_served_here(offered.name)) add(services, offered);
    }
  }
  return services;
}

std::set<std::string> ServiceDirectory::offered_there() const {
  std::set<std::string> names;
  for (const auto& [peer, lists] : peers_) {
    for (const ServiceName& offered : lists.offered) {
      if (!is_served_here(offered.name)) names.insert(offered.name);
    }
  }
  return names;
}

std::set<ServiceName> ServiceDirectory::asked() const {
  std::set<ServiceName> services;
  for (const auto& [peer, lists] : peers_) {
    for (const ServiceName& wanted : lists.wanted) {
      if (rules_.served(wanted.name) != Crossing::no) add(services, wanted);
    }
  }
  return services;
}

bool ServiceDirectory::has_changed(Time now) {
  const bool is_due = now >= changes_at_;
  if (!std::exchange(changed_, false) && !is_due) return false;
  changes_at_ = deadline(now);
  return true;
}

Time ServiceDirectory::deadline(Time now) const {
  Time next = never;
  for (const auto& [client, since] : clients_) {
    if (since + own_host_first > now) next = std::min(next, since + own_host_first);
  }
  return next;
}

}  // namespace tocsin::router
