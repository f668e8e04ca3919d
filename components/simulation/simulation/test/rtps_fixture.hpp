// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "geometry/wall.hpp"
#include "pacer.hpp"
#include "rtps.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin::simulation {

using Message = topic::EmergencyStop::Message;
constexpr double delay_s = 0.01;

inline QosProfile best_effort() {
  QosProfile qos;
  qos.reliability = "best_effort";
  return qos;
}

inline QosProfile reliable(int depth) {
  QosProfile qos;
  qos.depth = depth;
  return qos;
}

inline QosProfile state() {
  QosProfile qos;
  qos.durability = "transient_local";
  return qos;
}

/// A writer, a reader and the link between them, which is dead from 10 s to 15 s.
class RtpsTest : public ::testing::Test {
 protected:
  RtpsTest() {
    radio::ChannelParams params;
    params.mode = "bernoulli";
    params.delay_s = delay_s;
    params.outages_s = {10, 5};
    link_ = std::make_unique<RadioLink>(core_, params, std::vector<geometry::Wall>{}, 1);
  }
  void use(const QosProfile& qos) {
    end_.type = &type_info<Message>();
    const RtpsWriter::Owner owner{radio::Direction::downlink, 7, &end_, &origin_};
    writer_ = RtpsWriter::make(core_, *link_, owner, qos, pacer_.get());
    reader_ =
        RtpsReader::make(core_, *link_, qos, [this](const Change& change, std::uint64_t source) {
          EXPECT_EQ(source, 7U);
          got_.push_back(change.sequence);
          got_at_ = core_.now;
        });
  }
  /// They know each other from half a second after the start on.
  void connect(const QosProfile& qos) {
    use(qos);
    writer_->match(*reader_);
    run_until(0.5);
    before_ = link_->pushed();
  }
  [[nodiscard]] std::uint64_t pushed() const { return link_->pushed() - before_; }
  /// From now on writers are bound to so many bytes in 10 ms.
  void bound(int bytes_per_period) {
    FlowController controller;
    controller.max_bytes_per_period = bytes_per_period;
    pacer_ = std::make_unique<Pacer>(core_, controller);
  }
  void write(int count = 1) {
    for (int i = 0; i < count; ++i) ASSERT_TRUE(writer_->send(&message_));
  }
  /// Until `s` seconds after the start.
  void run_until(double s) {
    const Time end = start_time + seconds(s);
    const auto next = [this] { return std::min(core_.events.next(), link_->next_event()); };
    for (Time at = next(); at <= end; at = next()) {
      core_.now = std::max(core_.now, at);
      core_.events.run(core_.now);
      link_->advance();
    }
    core_.now = end;
  }

  using Sequences = std::vector<std::uint64_t>;
  Core core_;
  Message message_;
  std::unique_ptr<RadioLink> link_;
  TopicEnd end_;
  Origin origin_;
  std::unique_ptr<Pacer> pacer_;
  std::unique_ptr<RtpsWriter> writer_;
  std::unique_ptr<RtpsReader> reader_;
  Sequences got_;
  Time got_at_{};
  std::uint64_t before_ = 0;
};

}  // namespace tocsin::simulation
