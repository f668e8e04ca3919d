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

using FillInMessage = tocsin_msgs::msg::FillIn;

inline constexpr FlowId peer_fill_ins = 700;

/// A router that stores battery_state, on a scripted link with a station.
class FillInLinkTest : public LinkRouterTest {
 protected:
  FillInLinkTest() {
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
  [[nodiscard]] FlowId fill_ins() const { return script_.opened_for(fill_in_topic); }
  void meet_station() {
    meet();
    begin_peer_flow("link_receipt", receipt_flow);
    listen(fill_ins());
  }
  /// The sequences that were filled in, by each message.
  [[nodiscard]] std::vector<std::uint64_t> sent() const {
    std::vector<std::uint64_t> sequences;
    for (const ScriptedLink::Sent& one : script_.sent) {
      if (one.flow != fill_ins()) continue;
      for (const auto& sample : message_of(one).samples()) {
        sequences.push_back(sample.sequence_number());
      }
    }
    return sequences;
  }
  [[nodiscard]] static const FillInMessage& message_of(const ScriptedLink::Sent& one) {
    return *static_cast<const FillInMessage*>(one.sample.content.get());
  }
  void confirm(std::uint32_t session, std::uint32_t number, std::uint32_t count) {
    auto receipt = std::make_shared<Receipt>();
    receipt->from_life(station);
    receipt->to_life(ScriptedLink::own_life);
    receipt->count(count);
    receipt->made_ns(host_->bus.now().time_since_epoch().count());
    receipt->fill_in_session(session);
    receipt->fill_in_number(number);
    tell(receipt);
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
  /// The highest number of a peer's flow that a receipt tells of.
  [[nodiscard]] std::uint32_t confirmed_of(std::uint32_t wire_id) const {
    std::uint32_t highest = 0;
    for (const ScriptedLink::Sent& one : script_.sent) {
      if (one.flow != script_.opened_for("link_receipt")) continue;
      const auto& receipt = *static_cast<const Receipt*>(one.sample.content.get());
      for (std::size_t i = 0; i < receipt.streams().size(); ++i) {
        if (receipt.streams()[i] == wire_id) highest = std::max(highest, receipt.highest()[i]);
      }
    }
    return highest;
  }
  /// A batch of the peer.
  void fill_in(std::uint32_t number, const std::vector<std::uint64_t>& sequences,
               const std::string& topic = "goal") {
    auto message = std::make_shared<FillInMessage>();
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
    sample.sequence = ++fill_in_number_;
    script_.happen(
        link_event::LinkSample{peer_fill_ins, fill_in_number_, sample, host_->bus.now()});
    run(0.2);  // readers have found the topic
  }
  [[nodiscard]] std::vector<std::uint64_t> given() const {
    std::vector<std::uint64_t> sequences;
    for (const ScriptedLink::Given& one : script_.given) {
      sequences.push_back(one.sample.sequence);
    }
    return sequences;
  }
  /// Of the newest receipt.
  [[nodiscard]] std::uint32_t told_number() {
    run(1.1);
    std::uint32_t number = 0;
    for (const ScriptedLink::Sent& one : script_.sent) {
      if (one.flow != script_.opened_for("link_receipt")) continue;
      number = static_cast<const Receipt*>(one.sample.content.get())->fill_in_number();
    }
    return number;
  }

  TemporaryFolder folder_;
  AbsentDevices computer_;
  std::uint64_t fill_in_number_ = 0;
};

}  // namespace tocsin
