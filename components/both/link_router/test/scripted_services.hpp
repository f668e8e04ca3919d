// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "runtime/middleware/host_services.hpp"

namespace tocsin {

/// Services of a host that a test makes up, and which note what the router does.
class ScriptedServices final : public HostServices {
 public:
  struct Replied {
    std::string service;
    CallId id;
    std::vector<std::uint8_t> message;
  };
  struct Asked {
    std::string service;
    std::vector<std::uint8_t> message;
  };

  [[nodiscard]] std::optional<HostServiceEvent> take() override {
    if (events.empty()) return std::nullopt;
    HostServiceEvent event = std::move(events.front());
    events.pop_front();
    return event;
  }
  void serve(const HostService& service) override { served[service.name] = service; }
  void end_serving(const std::string& name) override { served.erase(name); }
  void reply(const std::string& service, const CallId& id,
             std::vector<std::uint8_t> message) override {
    replied.push_back({service, id, std::move(message)});
  }
  void know(const std::set<std::string>& services) override { known = services; }
  void call(const HostService& service) override { called[service.name] = service; }
  void end_calling(const std::string& name) override { called.erase(name); }
  [[nodiscard]] std::optional<std::int64_t> ask(const std::string& service,
                                                std::vector<std::uint8_t> message) override {
    if (!has_server || called.count(service) == 0) return std::nullopt;
    asked.push_back({service, std::move(message)});
    return static_cast<std::int64_t>(asked.size());
  }

  std::deque<HostServiceEvent> events;
  std::map<std::string, HostService> served;
  std::map<std::string, HostService> called;
  std::set<std::string> known;
  std::vector<Replied> replied;
  std::vector<Asked> asked;
  bool has_server = true;
};

}  // namespace tocsin
