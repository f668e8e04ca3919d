// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "runtime/middleware/link_bus.hpp"

namespace tocsin {

/// A link on which nothing happens, for those who examine a router without running it.
class IdleLinkBus final : public LinkBus {
 public:
  explicit IdleLinkBus(TrafficRules rules) : rules_(std::move(rules)) {}

  [[nodiscard]] std::optional<LinkEvent> take() override { return std::nullopt; }
  [[nodiscard]] PeerId self() const override { return 0; }
  FlowId open(const Flow&, TrafficClass) override { return ++last_; }
  [[nodiscard]] std::uint32_t wire_id(FlowId, PathIndex) const override { return 0; }
  void close(FlowId) override {}
  [[nodiscard]] std::optional<std::uint64_t> send(FlowId, const CarriedSample&, SamplePiece,
                                                  PathIndex) override {
    return std::nullopt;
  }
  [[nodiscard]] std::size_t largest_piece() const override { return 0; }
  [[nodiscard]] CarriedSample join(const CarriedSample& last,
                                   const std::vector<std::shared_ptr<const void>>&) const override {
    return last;
  }
  void offer(FlowId) override {}
  FlowId offer(const Flow&) override { return ++last_; }
  void deliver(FlowId, const CarriedSample&) override {}
  [[nodiscard]] std::vector<std::uint8_t> bytes_of(const CarriedSample&) const override {
    return {};
  }
  [[nodiscard]] CarriedSample sample_of(std::vector<std::uint8_t>) const override { return {}; }
  [[nodiscard]] CarriedSample pack(const TypeInfo&, std::shared_ptr<const void>) const override {
    return {};
  }
  [[nodiscard]] std::shared_ptr<const void> unpack(const TypeInfo&,
                                                   const CarriedSample&) const override {
    return nullptr;
  }
  void say_stop(const StopValue&) override {}
  [[nodiscard]] StopNews take_stop_news() override { return {}; }
  [[nodiscard]] const TrafficRules& rules() const override { return rules_; }
  [[nodiscard]] LinkPackets packets() const override { return {}; }

 private:
  const TrafficRules rules_;
  FlowId last_ = 0;
};

}  // namespace tocsin
