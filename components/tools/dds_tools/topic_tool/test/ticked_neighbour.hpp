// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include "runtime/component.hpp"
#include "runtime/host_control.hpp"
#include "runtime/middleware/fast_dds_bus.hpp"

namespace tocsin {

/// A component on a host's domain of its own participant, ticked by a thread of the test: what a
/// program that is looked at finds there.
template <class Neighbour>
class TickedNeighbour {
 public:
  TickedNeighbour(int domain, const char* node)
      : bus_(make_fast_dds_bus(options(domain))),
        context_{*bus_, node, Role::uxv},
        component_(context_) {
    bus_->host_control().update_graph();
    thread_ = std::thread([this] { run(); });
  }
  ~TickedNeighbour() {
    ended_ = true;
    thread_.join();
  }
  TickedNeighbour(const TickedNeighbour&) = delete;
  TickedNeighbour& operator=(const TickedNeighbour&) = delete;
  [[nodiscard]] Neighbour& component() { return component_; }

 private:
  static BusOptions options(int domain) {
    BusOptions options;
    options.name = "neighbour";
    options.host_domain = domain;
    return options;
  }
  void run() {
    while (!ended_) {
      component_.tick(bus_->now());
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
  }
  std::unique_ptr<Bus> bus_;
  Context context_;
  Neighbour component_;
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

}  // namespace tocsin
