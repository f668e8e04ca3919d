// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/local_services.hpp"

#include <algorithm>
#include <cstring>

namespace tocsin {
namespace {

CallId id_of(std::int64_t client, std::int64_t number) {
  CallId id;
  std::memcpy(id.client.data(), &client, sizeof client);
  id.number = number;
  return id;
}

std::int64_t client_in(const CallId& id) {
  std::int64_t client = 0;
  std::memcpy(&client, id.client.data(), sizeof client);
  return client;
}

}  // namespace

class LocalServices::Server final : public ServerEnd {
 public:
  Server(LocalServices& home, std::string name, ServerReceiver& receiver)
      : home_(home), name_(std::move(name)), receiver_(receiver) {
    home_.services_[name_].servers.push_back(&receiver_);
    home_.wake_clients(name_);
  }
  ~Server() override {
    auto& all = home_.services_[name_].servers;
    all.erase(std::remove(all.begin(), all.end(), &receiver_), all.end());
    home_.wake_clients(name_);
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  void reply(const CallId& id, const std::shared_ptr<const void>& message) override {
    auto& clients = home_.services_[name_].clients;
    const auto asked = clients.find(client_in(id));
    if (asked != clients.end()) asked->second->receive({message, id.number});
  }

 private:
  LocalServices& home_;
  const std::string name_;
  ServerReceiver& receiver_;
};

class LocalServices::Client final : public ClientEnd {
 public:
  Client(LocalServices& home, std::string name, ClientReceiver& receiver)
      : home_(home), name_(std::move(name)), client_(++home.last_client_) {
    home_.services_[name_].clients[client_] = &receiver;
  }
  ~Client() override { home_.services_[name_].clients.erase(client_); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;
  std::optional<std::int64_t> send(const std::shared_ptr<const void>& message) override {
    if (!available()) return std::nullopt;
    home_.services_[name_].servers.front()->receive({message, id_of(client_, ++number_)});
    return number_;
  }
  [[nodiscard]] bool available() const override { return !home_.services_[name_].servers.empty(); }

 private:
  LocalServices& home_;
  const std::string name_;
  const std::int64_t client_;
  std::int64_t number_ = 0;
};

LocalServices::LocalServices() = default;
LocalServices::~LocalServices() = default;

std::unique_ptr<ServerEnd> LocalServices::serve(const ServiceEndpoint& endpoint,
                                                ServerReceiver& receiver) {
  return std::make_unique<Server>(*this, service_name(endpoint), receiver);
}

std::unique_ptr<ClientEnd> LocalServices::call(const ServiceEndpoint& endpoint,
                                               ClientReceiver& receiver) {
  return std::make_unique<Client>(*this, service_name(endpoint), receiver);
}

std::vector<std::string> LocalServices::called() const {
  std::vector<std::string> names;
  for (const auto& [name, service] : services_) {
    if (!service.clients.empty()) names.push_back(name);
  }
  return names;
}

void LocalServices::wake_clients(const std::string& name) {
  for (const auto& entry : services_[name].clients) entry.second->wake();
}

}  // namespace tocsin
