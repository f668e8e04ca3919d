// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "runtime/middleware/fast_dds_bus.hpp"

namespace tocsin {

constexpr int relay_dscp = 32;  ///< of class high

/// A router that carries everything at once, as it comes, large samples in pieces, and, if so
/// wanted, each compressed by the one before. Its thread has the network namespace of who makes it.
class Relay {
 public:
  enum class Compress { no, yes };
  explicit Relay(const BusOptions& options, Compress compress = Compress::no)
      : compress_(compress == Compress::yes), thread_([this, options] { run(options); }) {}
  ~Relay() {
    stopping_ = true;
    thread_.join();
  }
  [[nodiscard]] std::vector<link_event::LinkSample> crossed() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return crossed_;
  }
  /// What has crossed since it was asked last.
  [[nodiscard]] std::vector<link_event::LinkSample> take_crossed() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(crossed_, {});
  }
  /// What is sent from now on goes by this path.
  void take_path(PathIndex path) { path_ = path; }
  /// Peers of these hosts are lost from now on.
  void set_absent(const std::set<std::string>& hosts) {
    const std::lock_guard<std::mutex> lock(mutex_);
    absent_ = hosts;
  }
  /// Says it to the peers of the link from now on.
  void say_stop(const StopValue& value) {
    const std::lock_guard<std::mutex> lock(mutex_);
    stop_ = value;
  }
  /// Of values of the stop that were received, the last one's number; 0: none.
  [[nodiscard]] std::uint64_t stop_number() const { return stop_number_; }
  [[nodiscard]] std::vector<Flow> peer_flows() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return peer_flows_;
  }
  [[nodiscard]] std::vector<std::string> peers() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return peers_;
  }
  /// Flows that a reader of this host has found, once for each reader.
  [[nodiscard]] std::vector<FlowId> heard() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return heard_;
  }
  [[nodiscard]] int lost_peers() const { return lost_peers_; }
  [[nodiscard]] LinkPackets packets() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return packets_;
  }

 private:
  void run(const BusOptions& options) {
    const auto bus = make_fast_dds_link_bus(options, [] {});
    while (!stopping_) {
      while (auto event = bus->take()) {
        std::visit([&](auto& what) { on(*bus, what); }, *event);
      }
      {
        const std::lock_guard<std::mutex> lock(mutex_);
        packets_ = bus->packets();
        if (stop_) bus->say_stop(*stop_);
        if (absent_) bus->set_absent(*std::exchange(absent_, std::nullopt));
      }
      for (const auto& one : bus->take_stop_news().values) stop_number_ = one.value.number;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  void on(LinkBus& bus, const link_event::HostFlow& event) {
    sending_[event.flow] = bus.open(event.what, TrafficClass::high);
    bus.want(event.flow, true);
  }
  void on(LinkBus& bus, const link_event::HostFlowGone& event) {
    bus.close(sending_[event.flow]);
    sending_.erase(event.flow);
  }
  void on(LinkBus& bus, const link_event::HostSample& event) {
    const std::size_t largest = bus.largest_piece();
    const CarriedSample sample = as_sent(bus, event);
    const std::size_t bytes = sample.bytes;
    const auto count = static_cast<std::uint8_t>(
        largest > 0 && bytes > largest + 4 ? (bytes + largest - 1) / largest : 1);
    for (std::uint8_t i = 0; i < count; ++i) {
      (void)bus.send(sending_.at(event.flow), sample, {i, count}, path_);
    }
  }
  CarriedSample as_sent(LinkBus& bus, const link_event::HostSample& event) {
    if (!compress_) return event.sample;
    const auto last = last_sent_.find(event.flow);
    const auto compressed =
        bus.compress(event.sample, last != last_sent_.end() ? &last->second : nullptr);
    last_sent_[event.flow] = event.sample;
    return compressed.value_or(event.sample);
  }
  void on(LinkBus&, const link_event::PeerFound& event) {
    const std::lock_guard<std::mutex> lock(mutex_);
    peers_.push_back(event.name);
  }
  void on(LinkBus&, const link_event::PeerLost&) { ++lost_peers_; }
  void on(LinkBus& bus, const link_event::PeerFlow& event) {
    bus.offer(event.flow);
    const std::lock_guard<std::mutex> lock(mutex_);
    peer_flows_.push_back(event.what);
  }
  void on(LinkBus&, const link_event::PeerFlowGone& event) {
    const std::lock_guard<std::mutex> lock(mutex_);
    gone_.push_back(event.flow);
  }
  void on(LinkBus&, const link_event::PeerReaderMatched&) {}
  void on(LinkBus&, const link_event::PeerReaderGone&) {}
  void on(LinkBus&, const link_event::HostReaderMatched& event) {
    const std::lock_guard<std::mutex> lock(mutex_);
    heard_.push_back(event.flow);
  }
  void on(LinkBus& bus, link_event::LinkSample& event) {
    if (!event.piece.is_whole() && !join(bus, event)) return;
    const auto last = last_received_.find(event.flow);
    std::optional<CarriedSample> plain = event.sample;
    if (event.sample.coding.is_compressed) {
      plain = bus.restore(event.sample, last != last_received_.end() ? &last->second : nullptr);
    }
    if (!plain) return;
    last_received_[event.flow] = *plain;
    bus.deliver(event.flow, *plain);
    const std::lock_guard<std::mutex> lock(mutex_);
    crossed_.push_back(event);
  }
  /// Whether it is the last piece; then the sample is the whole one.
  bool join(const LinkBus& bus, link_event::LinkSample& event) {
    auto& pieces = partial_[{event.flow, event.sample.sequence}];
    pieces[event.piece.index] = event.sample.content;
    if (pieces.size() < event.piece.count) return false;
    std::vector<std::shared_ptr<const void>> contents;
    for (const auto& entry : pieces) contents.push_back(entry.second);
    event.sample = bus.join(event.sample, contents);
    return true;
  }

  const bool compress_;
  std::map<FlowId, CarriedSample> last_sent_;
  std::map<FlowId, CarriedSample> last_received_;
  std::mutex mutex_;
  std::map<FlowId, FlowId> sending_;
  std::map<std::pair<FlowId, std::uint64_t>, std::map<int, std::shared_ptr<const void>>> partial_;
  std::vector<link_event::LinkSample> crossed_;
  std::vector<Flow> peer_flows_;
  std::vector<std::string> peers_;
  std::vector<FlowId> gone_;
  std::vector<FlowId> heard_;
  LinkPackets packets_;
  std::optional<StopValue> stop_;
  std::optional<std::set<std::string>> absent_;
  std::atomic<std::uint64_t> stop_number_{0};
  std::atomic<PathIndex> path_{0};
  std::atomic<int> lost_peers_{0};
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace tocsin
