// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "link_router/link_receiver.hpp"
#include "link_router/link_sender.hpp"

namespace tocsin::router {

/// A short random run of two routers' decisions under faults: freezes, restarts, loss, replay,
/// reorder, duplication, and forged samples and acknowledgements.
///
/// What must hold: nothing honest is delivered twice, nothing of depth 1 out of order, and within
/// 2 s and one period after the last fault each stream is delivered again.
class FaultyLink {
 public:
  explicit FaultyLink(unsigned seed);
  /// What did not hold; empty when all did.
  [[nodiscard]] std::string run();
  [[nodiscard]] std::size_t deliveries() const { return deliveries_; }
  [[nodiscard]] std::size_t forged() const { return forged_; }

 private:
  struct Stream {
    StreamRule rule;
    Duration period;
    std::size_t bytes = 200;
    Time next;
    std::uint64_t sequence = 0;
    std::set<std::uint64_t> delivered;  ///< since the receiver's start
    Time again = never;                 ///< first delivery after the last fault
  };
  struct OnAir {
    Transmission what;
    TransmissionNumber number;
    bool honest;
  };
  [[nodiscard]] int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  [[nodiscard]] bool chance(double p) { return below(100'000) < p * 100'000; }
  void add_stream(StreamId id, Duration period, Duration lifespan, std::size_t depth);
  void restart_sender();
  void restart_receiver();
  void introduce();
  void fault();
  void forge_sample();
  void forge_acknowledgement();
  void replay();
  void step();
  void offer();
  void send();
  void receive();
  void take(StreamId id, const OnAir& one);
  void acknowledge();
  [[nodiscard]] bool sender_runs() const { return now_ >= sender_frozen_; }
  [[nodiscard]] bool receiver_runs() const { return now_ >= receiver_frozen_; }

  std::mt19937 random_;
  LinkRouterParams params_;
  std::map<StreamId, Stream> streams_;
  std::map<StreamId, TransmissionNumber> numbers_;
  Time now_{std::chrono::hours(1)};
  Time end_of_faults_;
  Time last_fault_ = never;
  Time sender_frozen_{};
  Time receiver_frozen_{};
  Duration clock_difference_{};
  InstanceId sender_instance_ = 0;
  InstanceId receiver_instance_ = 1000;
  std::unique_ptr<LinkSender> sender_;
  std::unique_ptr<LinkReceiver> receiver_;
  std::multimap<Time, OnAir> air_;
  std::vector<OnAir> received_;  ///< by whoever replays
  double loss_ = 0;
  std::string broken_;
  std::size_t deliveries_ = 0;
  std::size_t forged_ = 0;
};

}  // namespace tocsin::router
