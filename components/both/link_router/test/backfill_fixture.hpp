// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <set>
#include <utility>

#include "devices/computer.hpp"
#include "foundation/temporary_folder.hpp"
#include "link_router_fixture.hpp"
#include "runtime/middleware/link_permissions.hpp"

namespace tocsin {

using BackfillMessage = tocsin_msgs::msg::Backfill;

inline constexpr FlowId peer_backfills = 700;

/// A router of the vehicle with stores, on a scripted link with a station.
class StoreTest : public LinkRouterTest {
 protected:
  explicit StoreTest(const std::string& traffic) { start_with(traffic); }
  void start_with(const std::string& traffic) {
    script_.rules = TrafficRules(folder_.write("traffic.yaml", traffic), Role::uxv);
    start();
  }
  /// An instance of the router, the one before being over.
  void start(const std::string& directory = "store") {
    host_.reset();
    script_.opened.clear();
    script_.sent.clear();
    script_.offered_here.clear();
    LinkRouterComponent::Params params;
    params.store_directory = folder_.path(directory);
    LinkRouterTest::start(params, computer_);
  }
  [[nodiscard]] FlowId backfills() const { return script_.opened_for(backfill_topic); }
  void meet_station() {
    meet();
    begin_peer_flow("link_acknowledgement", acknowledgement_flow);
    listen(backfills());
  }
  [[nodiscard]] std::vector<const BackfillMessage*> batches() const {
    std::vector<const BackfillMessage*> all;
    for (const ScriptedLink::Sent& one : script_.sent) {
      if (one.flow != backfills()) continue;
      all.push_back(static_cast<const BackfillMessage*>(one.sample.content.get()));
    }
    return all;
  }
  /// The sequences that were backfilled, without repetitions of a batch in its session.
  [[nodiscard]] std::vector<std::uint64_t> sent() const {
    std::vector<std::uint64_t> sequences;
    std::set<std::pair<std::uint32_t, std::uint32_t>> numbers;
    for (const BackfillMessage* const one : batches()) {
      if (!numbers.emplace(one->session(), one->number()).second) continue;
      for (const auto& sample : one->samples()) sequences.push_back(sample.sequence_number());
    }
    return sequences;
  }
  /// The station acknowledges batches, and asks for these.
  void confirm(std::uint32_t session, std::uint32_t number,
               const std::vector<tocsin_msgs::msg::LogRequest>& requests = {}) {
    auto acknowledgement = std::make_shared<Acknowledgement>();
    acknowledgement->from_instance(station);
    acknowledgement->to_instance(ScriptedLink::own_instance);
    acknowledgement->made_ns(host_->bus.now().time_since_epoch().count());
    acknowledgement->backfill_session(session);
    acknowledgement->backfill_number(number);
    acknowledgement->requests(requests);
    tell(acknowledgement);
  }
  void ask(const std::vector<tocsin_msgs::msg::LogRequest>& requests) { confirm(0, 0, requests); }
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
  [[nodiscard]] tocsin_msgs::msg::LinkState state() {
    run(1.5);
    const auto states = host_->states.take();
    return states.empty() ? tocsin_msgs::msg::LinkState() : states.back();
  }
  void begin_stored_peer_flow(const std::string& topic = "goal") {
    Flow stored = flow(topic);
    stored.stored = true;
    script_.happen(link_event::PeerFlow{peer_flow, station, peer_flow + 1, stored});
    run(0);
  }
  /// The highest number of a peer's flow that an acknowledgement tells of.
  [[nodiscard]] std::uint32_t confirmed_of(std::uint32_t wire_id) const {
    std::uint32_t highest = 0;
    for (const ScriptedLink::Sent& one : script_.sent) {
      if (one.flow != script_.opened_for("link_acknowledgement")) continue;
      const auto& acknowledgement = *static_cast<const Acknowledgement*>(one.sample.content.get());
      for (std::size_t i = 0; i < acknowledgement.streams().size(); ++i) {
        if (acknowledgement.streams()[i] == wire_id)
          highest = std::max(highest, acknowledgement.highest()[i]);
      }
    }
    return highest;
  }
  /// A batch of the peer.
  void backfill(std::uint32_t number, const std::vector<std::uint64_t>& sequences,
                const std::string& topic = "goal") {
    auto message = std::make_shared<BackfillMessage>();
    message->from_instance(station);
    message->to_instance(ScriptedLink::own_instance);
    message->session(1);
    message->number(number);
    message->topic(topic);
    message->type("some_msgs::msg::dds_::Type_");
    for (const std::uint64_t sequence : sequences) {
      tocsin_msgs::msg::StoredSample sample;
      sample.source(3);
      sample.sequence_number(sequence);
      sample.sent_ns(1000);
      sample.data(std::vector<std::uint8_t>(20));
      message->samples().push_back(sample);
    }
    CarriedSample sample;
    sample.content = message;
    sample.bytes = 100;
    sample.sequence = ++backfill_number_;
    script_.happen(
        link_event::LinkSample{peer_backfills, backfill_number_, sample, host_->bus.now()});
    run(0.2);  // readers have found the topic
  }
  [[nodiscard]] std::vector<std::uint64_t> delivered() const {
    std::vector<std::uint64_t> sequences;
    for (const ScriptedLink::Delivered& one : script_.delivered) {
      sequences.push_back(one.sample.sequence);
    }
    return sequences;
  }
  /// Of the newest acknowledgement.
  [[nodiscard]] std::uint32_t confirmed_number() {
    run(1.1);
    std::uint32_t number = 0;
    for (const ScriptedLink::Sent& one : script_.sent) {
      if (one.flow != script_.opened_for("link_acknowledgement")) continue;
      number = static_cast<const Acknowledgement*>(one.sample.content.get())->backfill_number();
    }
    return number;
  }

  TemporaryFolder folder_;
  Computer computer_;
  std::uint64_t backfill_number_ = 0;
};

/// It stores battery_state.
class BackfillLinkTest : public StoreTest {
 protected:
  BackfillLinkTest()
      : StoreTest(
            "uxv:\n  low: {while_poor: drop, topics: [battery_state, cpu_load], "
            "store: [battery_state]}\n"
            "gcs: {low: {topics: [goal], store: [goal]}}\n") {}
};

inline constexpr FlowId camera_flow = 501;

/// It logs camera and odom.
class HistoryLinkTest : public StoreTest {
 protected:
  HistoryLinkTest()
      : StoreTest(
            "uxv:\n  low: {while_poor: drop, topics: [camera, cpu_load], log: [camera, odom]}\n") {}
};

}  // namespace tocsin
