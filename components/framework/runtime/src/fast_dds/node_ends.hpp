// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "fast_dds/service_ends.hpp"
#include "graph/ros_graph.hpp"

namespace tocsin {

/// An end that a node has as long as this lives.
class NodeEnd {
 public:
  NodeEnd(LocalNodes& nodes, std::string node, LocalNodes::End end, const Gid& gid)
      : nodes_(nodes), node_(std::move(node)), end_(end), gid_(gid) {
    nodes_.add(node_, end_, gid_);
  }
  ~NodeEnd() { nodes_.remove(node_, end_, gid_); }
  NodeEnd(const NodeEnd&) = delete;
  NodeEnd& operator=(const NodeEnd&) = delete;

 private:
  LocalNodes& nodes_;
  const std::string node_;
  const LocalNodes::End end_;
  const Gid gid_;
};

/// The services that this process calls, which discovery does not tell itself. Thread-safe.
class OwnCalls {
 public:
  void add(const std::string& service) {
    const std::lock_guard<std::mutex> lock(mutex_);
    services_.insert(service);
  }
  void remove(const std::string& service) {
    const std::lock_guard<std::mutex> lock(mutex_);
    services_.erase(services_.find(service));
  }
  [[nodiscard]] std::vector<std::string> all() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return {services_.begin(), services_.end()};
  }

 private:
  mutable std::mutex mutex_;
  std::multiset<std::string> services_;
};

/// A server that belongs to a node.
class NodeServer final : public ServerEnd {
 public:
  NodeServer(LocalNodes& nodes, const std::string& node, std::unique_ptr<DdsServer> server)
      : server_(std::move(server)),
        reader_(nodes, node, LocalNodes::End::reader, server_->reader()),
        writer_(nodes, node, LocalNodes::End::writer, server_->writer()) {}
  void reply(const CallId& id, const std::shared_ptr<const void>& message) override {
    server_->reply(id, message);
  }
  void flush() override { server_->flush(); }

 private:
  const std::unique_ptr<DdsServer> server_;
  const NodeEnd reader_;
  const NodeEnd writer_;
};

/// A client that belongs to a node.
class NodeClient final : public ClientEnd {
 public:
  NodeClient(LocalNodes& nodes, const ServiceEndpoint& endpoint, std::unique_ptr<DdsClient> client,
             OwnCalls& calls)
      : client_(std::move(client)),
        reader_(nodes, endpoint.node, LocalNodes::End::reader, client_->reader()),
        writer_(nodes, endpoint.node, LocalNodes::End::writer, client_->writer()),
        calls_(calls),
        service_(service_name(endpoint)) {
    calls_.add(service_);
  }
  ~NodeClient() override { calls_.remove(service_); }
  NodeClient(const NodeClient&) = delete;
  NodeClient& operator=(const NodeClient&) = delete;
  [[nodiscard]] std::optional<std::int64_t> send(
      const std::shared_ptr<const void>& message) override {
    return client_->send(message);
  }
  [[nodiscard]] bool available() const override { return client_->available(); }

 private:
  const std::unique_ptr<DdsClient> client_;
  const NodeEnd reader_;
  const NodeEnd writer_;
  OwnCalls& calls_;
  const std::string service_;
};

}  // namespace tocsin
