// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <string>

#include "fast_dds/node_ends.hpp"
#include "graph/ros_graph.hpp"
#include "link/service_table.hpp"
#include "runtime/logger.hpp"
#include "runtime/middleware/host_services.hpp"

namespace tocsin {

/// Servers and clients of any type at a participant of a host. Each side of a call speaks as it is
/// used to: requests of rmw_cyclonedds reach a server of rmw_fastrtps, and the other way round.
class FastDdsHostServices final : public HostServices {
 public:
  /// All outlive it. `table` is told by the participant what is announced; `nodes` have the ends.
  struct Home {
    FastDdsParticipant& participant;
    const std::string& ros_namespace;
    ServiceTable& table;
    LocalNodes& nodes;
    Logger& log;
  };
  explicit FastDdsHostServices(const Home& home) : home_(home) {}

  [[nodiscard]] std::optional<HostServiceEvent> take() override;
  void serve(const HostService& service) override;
  void end_serving(const std::string& name) override { servers_.erase(name); }
  void know(const std::set<std::string>& services) override;
  void reply(const std::string& service, const CallId& id,
             std::vector<std::uint8_t> message) override;
  void call(const HostService& service) override;
  void end_calling(const std::string& name) override { clients_.erase(name); }
  [[nodiscard]] std::optional<std::int64_t> ask(const std::string& service,
                                                std::vector<std::uint8_t> message) override;

 private:
  class Serving;
  class Calling;
  const Home home_;
  std::map<std::string, std::shared_ptr<Serving>> servers_;
  std::map<std::string, std::shared_ptr<Calling>> clients_;
};

}  // namespace tocsin
