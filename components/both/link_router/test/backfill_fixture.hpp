// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "devices/absent_devices.hpp"
#include "foundation/temporary_folder.hpp"
#include "link_router_fixture.hpp"
#include "runtime/middleware/link_permissions.hpp"

namespace tocsin {

using BackfillMessage = tocsin_msgs::msg::Backfill;

inline constexpr FlowId peer_backfills = 700;

/// A router that stores battery_state, on a scripted link with a station.
class BackfillLinkTest : public LinkRouterTest {
 protected:
  BackfillLinkTest() {
    (void)folder_.write("traffic.yaml",
                        "uxv:\n  low: {while_poor: drop, topics: [battery_state, cpu_load], "
                        "store: [battery_state]}\n"
                        "gcs: {low: {topics: [goal], store: [goal]}}\n");
    script_.rules = TrafficRules(folder_.path("traffic.yaml"), Role::uxv);
    start(folder_.path("store"));
  }
  /// A life of the router, the one before being over.
  void start(const std::string& directory) {
    host_.reset();
    script_.opened.clear();
    script_.sent.clear();
    script_.offered_here.clear();
    LinkRouterComponent::Params params;
    params.store_directory = directory;
    LinkRouterTest::start(params, computer_);
  }
  [[nodiscard]] FlowId backfills() const { return script_.opened_for(backfill_topic); }
  void meet_station() {
    meet();
    begin_peer_flow("link_acknowledgement", acknowledgement_flow);
    listen(backfills());
  }
  /// The sequences that were backfilled, by each message.
  [[nodiscard]] std::vector<std::uint64_t> sent() const {
    std::vector<std::uint64_t> sequences;
    for (const ScriptedLink::Sent& one : script_.sent) {
      if (one.flow != backfills()) continue;
      for (const auto& sample : message_of(one).samples()) {
        sequences.push_back(sample.sequence_number());
      }
    }
    return sequences;
  }
  [[nodiscard]] static const BackfillMessage& message_of(const ScriptedLink::Sent& one) {
    return *static_cast<const BackfillMessage*>(one.sample.content.get());
  }
  void confirm(std::uint32_t session, std::uint32_t number, std::uint32_t count) {
    auto acknowledgement = std::make_shared<Acknowledgement>();
    acknowledgement->from_life(station);
    acknowledgement->to_life(ScriptedLink::own_life);
    acknowledgement->count(count);
    acknowledgement->made_ns(host_->bus.now().time_since_epoch().count());
    acknowledgement->backfill_session(session);
    acknowledgement->backfill_number(number);
    tell(acknowledgement);
  }
  [[nodiscard]] tocsin_msgs::msg::StoredTopic told() {
    run(1.5);
    const auto states = host_->states.take();
    EXPECT_FALSE(states.empty());
    std::vector<tocsin_msgs::msg::StoredTopic> stored;
    if (!states.empty()) stored = states.back().stored();
    EXPECT_EQ(stored.size(), 1U);
    return stored.empty() ? tocsin_msgs::msg::StoredTopic() : stored.front();
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
    message->from_life(station);
    message->to_life(ScriptedLink::own_life);
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
  [[nodiscard]] std::vector<std::uint64_t> given() const {
    std::vector<std::uint64_t> sequences;
    for (const ScriptedLink::Given& one : script_.given) {
      sequences.push_back(one.sample.sequence);
    }
    return sequences;
  }
  /// Of the newest acknowledgement.
  [[nodiscard]] std::uint32_t told_number() {
    run(1.1);
    std::uint32_t number = 0;
    for (const ScriptedLink::Sent& one : script_.sent) {
      if (one.flow != script_.opened_for("link_acknowledgement")) continue;
      number = static_cast<const Acknowledgement*>(one.sample.content.get())->backfill_number();
    }
    return number;
  }

  TemporaryFolder folder_;
  AbsentDevices computer_;
  std::uint64_t backfill_number_ = 0;
};

}  // namespace tocsin
