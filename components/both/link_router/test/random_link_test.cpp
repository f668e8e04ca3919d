// SPDX-License-Identifier: Apache-2.0
// Random traffic over a random link with routers that restart: what must hold whatever happens. A
// failure names its seed.
#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "link_router/link_receiver.hpp"
#include "link_router/link_sender.hpp"

namespace tocsin::router {
namespace {

constexpr Duration ms = std::chrono::milliseconds(1);
constexpr int longest_delay_ms = 300;
constexpr int sources = 2;

class RandomLink {
 public:
  explicit RandomLink(unsigned seed) : random_(seed) {
    params_.queue_bytes = 1024 << below(6);
    params_.repair_first_s = 0.01 * (1 + below(20));
    for (StreamId stream = 1; stream <= 8; ++stream) rules_[stream] = random_rule(stream);
    restart_sender();
    restart_receiver();
  }

  void run(int steps) {
    for (int i = 0; i < steps && !::testing::Test::HasFailure(); ++i) step();
  }
  [[nodiscard]] std::size_t deliveries() const { return deliveries_; }

 private:
  /// In [0, n).
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  bool chance(double p) { return below(100000) < static_cast<int>(p * 100000); }

  StreamRule random_rule(StreamId stream) {
    StreamRule rule;
    rule.name = "topic" + std::to_string(stream);
    rule.traffic_class = traffic_classes[stream % 4];
    rule.repaired = chance(0.7);
    rule.depth = static_cast<std::size_t>(chance(0.6) ? 1 : 1 + below(4));
    if (chance(0.4)) rule.lifespan = (50 + below(2000)) * ms;
    rule.durable = chance(0.4);
    if (rule.traffic_class >= TrafficClass::normal) {
      rule.while_paused = static_cast<WhilePaused>(below(3));
      rule.adaptive = chance(0.3);
    }
    return rule;
  }

  void restart_sender() {
    sender_ = std::make_unique<LinkSender>(params_);
    ++sender_instance_;
    air_.clear();
    numbers_.clear();
    first_sent_.clear();
    paused_ = false;
    for (const auto& [stream, rule] : rules_) sender_->add_stream(stream, rule);
    if (receiver_) receiver_->on_peer("vehicle", sender_instance_);
    meet();
  }
  void restart_receiver() {
    receiver_ = std::make_unique<LinkReceiver>();
    ++receiver_instance_;
    receiver_->on_peer("vehicle", sender_instance_);
    delivered_.clear();
    meet();
  }
  void meet() {
    if (!receiver_) return;
    sender_->on_peer("station", receiver_instance_, now_);
    for (const auto& [stream, rule] : rules_) {
      receiver_->on_stream("vehicle", stream, rule);
      sender_->set_wanted("station", stream, true, now_);
    }
  }

  void step() {
    now_ += Duration{1 + below(8'000'000)};
    disturb();
    offer();
    arrive();
    send();
    answer();
    check_counts();
  }

  void disturb() {
    if (chance(0.002)) loss_ = chance(0.3) ? 1 : 0.01 * below(60);
    if (chance(0.002)) delay_ms_ = 1 + below(longest_delay_ms);
    if (chance(0.002)) {
      paused_ = !paused_;
      sender_->set_paused(paused_, now_);
    }
    if (chance(0.0005)) restart_sender();
    if (chance(0.0005)) restart_receiver();
  }

  void offer() {
    while (chance(0.4)) {
      const auto stream = static_cast<StreamId>(1 + below(8));
      const auto source = static_cast<SourceId>(below(sources));
      const bool small = rules_[stream].traffic_class <= TrafficClass::high || chance(0.9);
      const auto bytes = static_cast<std::size_t>(1 + below(small ? 800 : 30000));
      sender_->offer(stream, {{source, ++sequences_[{stream, source}], now_}, bytes, nullptr},
                     now_);
    }
  }

  void send() {
    while (const auto one = sender_->next(now_)) {
      const TransmissionNumber number = ++numbers_[one->stream];
      sender_->on_written(*one, number);
      check_sent(*one);
      if (chance(loss_)) continue;
      const int copies = chance(0.02) ? 2 : 1;
      for (int i = 0; i < copies; ++i)
        air_.emplace(now_ + (1 + below(delay_ms_)) * ms, std::pair(*one, number));
    }
    EXPECT_GT(sender_->deadline(now_), now_);
  }

  void check_sent(const Transmission& one) {
    const StreamRule& rule = rules_[one.stream];
    EXPECT_TRUE(!paused_ || rule.while_paused == WhilePaused::send) << "silent while paused";
    EXPECT_LE(now_ - one.sample.origin.sent, rule.lifespan);
    auto& sent = first_sent_[{one.stream, one.sample.origin.source}];
    const auto newer = std::distance(sent.upper_bound(one.sample.origin.sequence), sent.end());
    if (sent.count(one.sample.origin.sequence) != 0) {
      const std::size_t kept = one.piece.is_whole() ? rule.depth : rule.depth + 1;
      EXPECT_LT(newer, static_cast<std::ptrdiff_t>(kept)) << "a superseded repair";
      return;
    }
    sent.insert(one.sample.origin.sequence);
    EXPECT_EQ(newer, 0) << "in the order of the source";
    const LinkStateValues state = sender_->state(now_);
    for (const TrafficClass higher : {TrafficClass::critical, TrafficClass::high}) {
      if (higher >= rule.traffic_class) break;
      EXPECT_EQ(state.classes[index_of(higher)].waiting_samples, 0U) << "strict priority";
    }
  }

  void arrive() {
    for (; !air_.empty() && air_.begin()->first <= now_; air_.erase(air_.begin())) {
      const auto& [one, number] = air_.begin()->second;
      const Origin& origin = one.sample.origin;
      const Arrived arrived{one.stream, number, origin, one.piece, nullptr};
      if (!receiver_->on_piece("vehicle", arrived, now_)) continue;
      const Disposition disposition = receiver_->on_arrived("vehicle", arrived, now_);
      if (disposition != Disposition::deliver) continue;
      ++deliveries_;
      const StreamRule& rule = rules_[one.stream];
      auto& before = delivered_[{one.stream, origin.source}];
      EXPECT_TRUE(before.insert(origin.sequence).second) << "delivered twice";
      EXPECT_TRUE(rule.depth > 1 || *before.rbegin() == origin.sequence) << "out of order";
      const Duration tolerance = (longest_delay_ms + 10) * ms;
      if (rule.lifespan != Duration::max()) {
        EXPECT_LE(now_ - origin.sent, rule.lifespan + tolerance);
      }
    }
  }

  void answer() {
    while (const auto acknowledgement = receiver_->take_acknowledgement(now_)) {
      if (!chance(loss_))
        sender_->on_acknowledgement("station", acknowledgement->acknowledgement, now_);
    }
    EXPECT_GT(receiver_->deadline(), now_);
  }

  void check_counts() {
    const LinkStateValues state = sender_->state(now_);
    for (const TrafficClass traffic_class : traffic_classes) {
      const ClassCounts& counts = state.classes[index_of(traffic_class)];
      std::uint64_t dropped = 0;
      for (const std::uint64_t count : counts.dropped) dropped += count;
      EXPECT_EQ(counts.offered, counts.sent + dropped + counts.waiting_samples);
      EXPECT_GE(counts.sent, counts.delivered + counts.lost + counts.unwanted);
      EXPECT_GE(counts.delivered, counts.late);
      if (counts.waiting_samples > 1 && !paused_) {
        EXPECT_LE(counts.waiting_bytes, static_cast<std::size_t>(params_.queue_bytes));
      }
    }
    EXPECT_GE(state.scale, params_.scale_min);
    EXPECT_LE(state.scale, 1);
  }

  using Key = std::pair<StreamId, SourceId>;
  std::mt19937 random_;
  LinkRouterParams params_;
  std::map<StreamId, StreamRule> rules_;
  Time now_{std::chrono::hours(1)};
  InstanceId sender_instance_ = 0;
  InstanceId receiver_instance_ = 1000;
  std::unique_ptr<LinkSender> sender_;
  std::unique_ptr<LinkReceiver> receiver_;
  bool paused_ = false;
  double loss_ = 0;
  int delay_ms_ = 5;
  std::multimap<Time, std::pair<Transmission, TransmissionNumber>> air_;
  std::map<Key, std::uint64_t> sequences_;
  std::map<StreamId, TransmissionNumber> numbers_;
  std::map<Key, std::set<std::uint64_t>> first_sent_;
  std::map<Key, std::set<std::uint64_t>> delivered_;
  std::size_t deliveries_ = 0;
};

TEST(RandomLink, KeepsItsInvariants) {
  std::size_t deliveries = 0;
  for (unsigned seed = 1; seed <= 25 && !HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomLink link(seed);
    link.run(2500);
    deliveries += link.deliveries();
  }
  EXPECT_GT(deliveries, 5000U);
}

}  // namespace
}  // namespace tocsin::router
