// SPDX-License-Identifier: Apache-2.0
#include "link/fast_dds_host_services.hpp"

#include <stdexcept>
#include <utility>

#include "foundation/ros_names.hpp"
#include "graph/node_of_service.hpp"
#include "graph/ros_graph.hpp"
#include "idl_support/raw_type.hpp"
#include "link/router_name.hpp"

namespace tocsin {
namespace {

/// As the queues of ROS 2's services.
constexpr int raw_service_depth = 10;

ServiceEndpoint raw_endpoint(const HostService& service) {
  return {service.name, &raw_type(wire_type(service.type + "_Request")),
          &raw_type(wire_type(service.type + "_Response")), "", raw_service_depth};
}

/// Of the peer's node whose own service it is, as if it were here; else the router's.
std::string server_node(const HostService& service) {
  const std::string node = node_of_service(service.name);
  return node.empty() ? router_node : node;
}

std::vector<std::uint8_t> bytes_in(const std::shared_ptr<const void>& message) {
  return static_cast<const EncodedMessage*>(message.get())->bytes;
}

std::shared_ptr<const void> encoded(std::vector<std::uint8_t> bytes) {
  return std::make_shared<const EncodedMessage>(EncodedMessage{std::move(bytes)});
}

}  // namespace

class FastDdsHostServices::Serving final : public ServerReceiver {
 public:
  Serving(const Home& home, const HostService& service)
      : table_(home.table),
        name_(service.name),
        end_(home.participant, home.ros_namespace, raw_endpoint(service), *this),
        reader_(home.nodes, server_node(service), LocalNodes::End::reader, end_.reader()),
        writer_(home.nodes, server_node(service), LocalNodes::End::writer, end_.writer()) {}
  void receive(ServiceRequest&& request) override {
    table_.push(host_service_event::Request{name_, request.id, bytes_in(request.message)});
  }
  void wake() override { table_.push(host_service_event::Changed{name_}); }
  [[nodiscard]] DdsServer& end() { return end_; }

 private:
  ServiceTable& table_;
  const std::string name_;
  DdsServer end_;  // behind what it calls back
  const NodeEnd reader_;
  const NodeEnd writer_;
};

class FastDdsHostServices::Calling final : public ClientReceiver {
 public:
  Calling(const Home& home, const HostService& service)
      : table_(home.table),
        name_(service.name),
        end_(home.participant, home.ros_namespace, raw_endpoint(service), *this),
        reader_(home.nodes, router_node, LocalNodes::End::reader, end_.reader()),
        writer_(home.nodes, router_node, LocalNodes::End::writer, end_.writer()) {}
  void receive(ServiceReply&& reply) override {
    table_.push(host_service_event::Reply{name_, reply.number, bytes_in(reply.message)});
  }
  void wake() override { table_.push(host_service_event::Changed{name_}); }
  [[nodiscard]] DdsClient& end() { return end_; }

 private:
  ServiceTable& table_;
  const std::string name_;
  DdsClient end_;  // as above
  const NodeEnd reader_;
  const NodeEnd writer_;
};

std::optional<HostServiceEvent> FastDdsHostServices::take() {
  auto event = home_.table.pop();
  if (!event) return event;
  if (const auto* changed = std::get_if<host_service_event::Changed>(&*event)) {
    const auto server = servers_.find(changed->service);
    if (server != servers_.end()) server->second->end().flush();
  }
  return event;
}

void FastDdsHostServices::serve(const HostService& service) {
  try {
    servers_[service.name] = std::make_shared<Serving>(home_, service);
  } catch (const std::runtime_error& error) {
    servers_.erase(service.name);
    home_.log.error("service /{}: {}", service.name, error.what());
  }
}

void FastDdsHostServices::know(const std::set<std::string>& services) {
  std::set<std::string> nodes;
  for (const std::string& service : services) nodes.insert(node_of_service(service));
  home_.nodes.show(std::move(nodes));
}

void FastDdsHostServices::reply(const std::string& service, const CallId& id,
                                std::vector<std::uint8_t> message) {
  const auto server = servers_.find(service);
  if (server != servers_.end()) server->second->end().reply(id, encoded(std::move(message)));
}

void FastDdsHostServices::call(const HostService& service) {
  try {
    clients_[service.name] = std::make_shared<Calling>(home_, service);
  } catch (const std::runtime_error& error) {
    clients_.erase(service.name);
    home_.log.error("service /{}: {}", service.name, error.what());
  }
}

std::optional<std::int64_t> FastDdsHostServices::ask(const std::string& service,
                                                     std::vector<std::uint8_t> message) {
  const auto client = clients_.find(service);
  if (client == clients_.end()) return std::nullopt;
  return client->second->end().send(encoded(std::move(message)));
}

}  // namespace tocsin
