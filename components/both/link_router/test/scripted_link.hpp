// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "runtime/middleware/link_bus.hpp"
#include "runtime/sim_bus.hpp"
#include "scripted_services.hpp"

namespace tocsin {

/// A link whose events a test makes up, and which notes what the router does.
class ScriptedLink {
 public:
  static constexpr PeerId own_instance = 41;

  struct Opened {
    Flow flow;
    TrafficClass traffic_class;
    bool closed = false;
  };
  struct Sent {
    FlowId flow;
    CarriedSample sample;
    SamplePiece piece{};
    PathIndex path = 0;
  };
  struct Delivered {
    FlowId flow;
    CarriedSample sample;
  };

  void happen(LinkEvent event) {
    events.push_back(std::move(event));
    on_event();
  }
  /// The flow that was opened for a topic.
  [[nodiscard]] FlowId opened_for(const std::string& topic) const {
    for (const auto& entry : opened) {
      if (entry.second.flow.topic == topic) return entry.first;
    }
    return 0;
  }
  [[nodiscard]] std::size_t sent_on(FlowId flow) const {
    std::size_t count = 0;
    for (const Sent& one : sent) count += one.flow == flow ? 1 : 0;
    return count;
  }

  std::deque<LinkEvent> events;
  std::function<void()> on_event = [] {};
  std::map<FlowId, Opened> opened;
  std::vector<Sent> sent;
  std::vector<Delivered> delivered;
  std::vector<FlowId> offered;
  std::set<FlowId> wanted;              ///< of the host, on demand
  int wants = 0;                        ///< calls that said so, or that they are not
  std::map<FlowId, Flow> offered_here;  ///< flows that are no peer's
  PathIndex paths = 1;
  std::vector<bool> gate;            ///< each time that it changed: open
  std::vector<std::uint64_t> bases;  ///< of what was to be restored; 0: none
  bool damaged = false;              ///< what comes compressed
  bool is_up = true;
  bool host_reads = true;  ///< readers of the host hear at once what is offered there
  std::vector<std::string> sites;
  std::set<std::string> absent;  ///< as the router said last
  std::vector<StopValue> said_stops;
  StopNews stop_news;  ///< what the router is told next
  TrafficRules rules;
  ScriptedServices services;
};

/// What a router holds of it.
class ScriptedLinkBus final : public LinkBus {
 public:
  explicit ScriptedLinkBus(ScriptedLink& script) : script_(script) {}

  [[nodiscard]] std::optional<LinkEvent> take() override {
    if (script_.events.empty()) return std::nullopt;
    LinkEvent event = std::move(script_.events.front());
    script_.events.pop_front();
    return event;
  }
  [[nodiscard]] PeerId self() const override { return ScriptedLink::own_instance; }
  [[nodiscard]] std::string host() const override { return "here"; }
  [[nodiscard]] std::vector<std::string> sites() const override { return script_.sites; }
  void set_absent(const std::set<std::string>& hosts) override { script_.absent = hosts; }
  [[nodiscard]] PathIndex paths() const override { return script_.paths; }
  void want(FlowId host_flow, bool wanted) override {
    ++script_.wants;
    wanted ? (void)script_.wanted.insert(host_flow) : (void)script_.wanted.erase(host_flow);
  }
  FlowId open(const Flow& flow, TrafficClass traffic_class) override {
    script_.opened[++last_] = {flow, traffic_class};
    return last_;
  }
  [[nodiscard]] std::uint32_t wire_id(FlowId flow, PathIndex path) const override {
    return (path + 1U) * 1000 + flow;
  }
  void close(FlowId flow) override { script_.opened[flow].closed = true; }
  [[nodiscard]] std::optional<std::uint64_t> send(FlowId flow, const CarriedSample& sample,
                                                  SamplePiece piece, PathIndex path) override {
    if (!script_.is_up) return std::nullopt;
    script_.sent.push_back({flow, sample, piece, path});
    return ++numbers_[{flow, path}];
  }
  [[nodiscard]] std::size_t largest_piece() const override { return 1000; }
  /// A quarter is left of a sample, a tenth with a base.
  [[nodiscard]] std::optional<CarriedSample> compress(const CarriedSample& sample,
                                                      const CarriedSample* base) override {
    CarriedSample compressed = sample;
    compressed.bytes = sample.bytes / (base != nullptr ? 10 : 4);
    const std::uint64_t before = base != nullptr ? sample.sequence - base->sequence : 0;
    compressed.coding = {true, static_cast<std::uint8_t>(before)};
    return compressed;
  }
  [[nodiscard]] std::optional<CarriedSample> restore(const CarriedSample& compressed,
                                                     const CarriedSample* base) override {
    script_.bases.push_back(base != nullptr ? base->sequence : 0);
    if (script_.damaged) return std::nullopt;
    CarriedSample plain = compressed;
    plain.bytes = 1000;
    plain.coding = {};
    return plain;
  }
  [[nodiscard]] CarriedSample join(
      const CarriedSample& last,
      const std::vector<std::shared_ptr<const void>>& pieces) const override {
    CarriedSample whole = last;
    whole.bytes = static_cast<std::uint32_t>(last.bytes * pieces.size());
    return whole;
  }
  void offer(FlowId flow) override {
    script_.offered.push_back(flow);
    if (script_.host_reads) script_.happen(link_event::HostReaderMatched{flow});
  }
  FlowId offer(const Flow& flow) override {
    script_.offered_here[++last_] = flow;
    if (script_.host_reads) script_.happen(link_event::HostReaderMatched{last_});
    return last_;
  }
  void deliver(FlowId flow, const CarriedSample& sample) override {
    script_.delivered.push_back({flow, sample});
  }
  [[nodiscard]] std::vector<std::uint8_t> bytes_of(const CarriedSample& sample) const override {
    return std::vector<std::uint8_t>(sample.bytes, static_cast<std::uint8_t>(sample.sequence));
  }
  [[nodiscard]] CarriedSample sample_of(std::vector<std::uint8_t> bytes) const override {
    CarriedSample sample;
    sample.bytes = static_cast<std::uint32_t>(bytes.size());
    sample.content = std::make_shared<std::vector<std::uint8_t>>(std::move(bytes));
    return sample;
  }
  [[nodiscard]] CarriedSample pack(const TypeInfo& type,
                                   std::shared_ptr<const void> message) const override {
    CarriedSample sample;
    sample.bytes = static_cast<std::uint32_t>(type.serialized_size(message.get()));
    sample.content = std::move(message);
    return sample;
  }
  [[nodiscard]] std::shared_ptr<const void> unpack(const TypeInfo&,
                                                   const CarriedSample& sample) const override {
    return sample.content;
  }
  void on_gate(bool open) override { script_.gate.push_back(open); }
  [[nodiscard]] HostServices* services() override {
    return script_.rules.call_classes().empty() ? nullptr : &script_.services;
  }
  void say_stop(const StopValue& value) override { script_.said_stops.push_back(value); }
  [[nodiscard]] StopNews take_stop_news() override { return std::exchange(script_.stop_news, {}); }
  [[nodiscard]] const TrafficRules& rules() const override { return script_.rules; }
  [[nodiscard]] LinkPackets packets() const override {
    return {7, 700, 2, 200, 90, 50, 40, {400, 0, 0, 100}};
  }

 private:
  ScriptedLink& script_;
  FlowId last_ = 0;
  std::map<std::pair<FlowId, PathIndex>, std::uint64_t> numbers_;
};

/// The bus of a host whose router has a scripted link.
class RoutedSimBus final : public SimBus, private LinkAccess {
 public:
  explicit RoutedSimBus(ScriptedLink& script) : script_(script) {}
  [[nodiscard]] LinkAccess* link_access() override { return this; }

 private:
  std::unique_ptr<LinkBus> open_link(const std::function<void()>& on_event) override {
    script_.on_event = on_event;
    return std::make_unique<ScriptedLinkBus>(script_);
  }
  ScriptedLink& script_;
};

}  // namespace tocsin
