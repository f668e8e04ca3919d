// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <vector>

#include "devices/absent_devices.hpp"
#include "foundation/temporary_folder.hpp"
#include "link_router_fixture.hpp"
#include "runtime/middleware/link_permissions.hpp"

namespace tocsin {

inline constexpr FlowId camera_flow = 501;

/// A router that logs camera and odom, on a scripted link with a station.
class HistoryLinkTest : public LinkRouterTest {
 protected:
  HistoryLinkTest() {
    (void)folder_.write("traffic.yaml",
                        "uxv:\n  low: {while_poor: drop, topics: [camera, cpu_load], "
                        "log: [camera, odom]}\n");
    script_.rules = TrafficRules(folder_.path("traffic.yaml"), Role::uxv);
    start();
  }
  /// A life of the router, the one before being over.
  void start(double fetch_around_stop_s = 0) {
    host_.reset();
    script_.opened.clear();
    script_.sent.clear();
    LinkRouterComponent::Params params;
    params.store_directory = folder_.path("store");
    params.fetch_around_stop_s = fetch_around_stop_s;
    LinkRouterTest::start(params, computer_);
  }
  [[nodiscard]] FlowId backfills() const { return script_.opened_for(backfill_topic); }
  void meet_station() {
    meet();
    begin_peer_flow("link_acknowledgement", acknowledgement_flow);
    listen(backfills());
  }
  [[nodiscard]] std::vector<const tocsin_msgs::msg::Backfill*> batches() const {
    std::vector<const tocsin_msgs::msg::Backfill*> all;
    for (const ScriptedLink::Sent& one : script_.sent) {
      if (one.flow != backfills()) continue;
      all.push_back(static_cast<const tocsin_msgs::msg::Backfill*>(one.sample.content.get()));
    }
    return all;
  }
  /// Without repetitions of batches.
  [[nodiscard]] std::vector<std::uint64_t> sent() const {
    std::vector<std::uint64_t> sequences;
    std::set<std::uint32_t> numbers;
    for (const tocsin_msgs::msg::Backfill* const one : batches()) {
      if (!numbers.insert(one->number()).second) continue;
      for (const auto& sample : one->samples()) sequences.push_back(sample.sequence_number());
    }
    return sequences;
  }
  [[nodiscard]] std::int64_t wall_ns() const { return host_->bus.wall_ns(host_->bus.now()); }
  /// Of the last seconds until now.
  [[nodiscard]] tocsin_msgs::msg::LogRequest request(const std::string& topic, double last_s = 3600,
                                                     std::uint64_t id = 41) const {
    tocsin_msgs::msg::LogRequest request;
    request.id(id);
    request.topic(topic);
    request.from_ns(wall_ns() - seconds(last_s).count());
    request.to_ns(wall_ns());
    return request;
  }
  /// The station tells it with an acknowledgement, and what of backfills it has given.
  void ask(const std::vector<tocsin_msgs::msg::LogRequest>& requests, std::uint32_t session = 0,
           std::uint32_t number = 0) {
    auto acknowledgement = std::make_shared<Acknowledgement>();
    acknowledgement->from_life(station);
    acknowledgement->to_life(ScriptedLink::own_life);
    acknowledgement->count(++acknowledgements_);
    acknowledgement->made_ns(host_->bus.now().time_since_epoch().count());
    acknowledgement->backfill_session(session);
    acknowledgement->backfill_number(number);
    acknowledgement->requests(requests);
    tell(acknowledgement);
  }
  [[nodiscard]] tocsin_msgs::msg::LinkState state() {
    run(1.5);
    const auto states = host_->states.take();
    return states.empty() ? tocsin_msgs::msg::LinkState() : states.back();
  }

  TemporaryFolder folder_;
  AbsentDevices computer_;
  std::uint32_t acknowledgements_ = 0;
};

}  // namespace tocsin
