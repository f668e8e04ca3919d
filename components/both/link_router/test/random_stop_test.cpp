// SPDX-License-Identifier: Apache-2.0
// Stops over a radio that loses and replays, with restarts and a forger.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

#include "link_router/stop_listener.hpp"
#include "station_side.hpp"

namespace tocsin::router {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// A radio that loses, doubles, delays and replays, and a forger who knows all that was sent.
class StopRun {
 public:
  explicit StopRun(std::uint64_t seed) : random_(seed) {}
  /// What was promised and does not hold; empty: nothing.
  std::string run() {
    for (int step = 0; step < 400; ++step) {
      now_ += milliseconds(25);
      if (chance(40)) press(!pressed_);
      if (step % 4 == 0) say();
      if (chance(10)) forge();
      if (chance(60)) restart();
      deliver();
      const std::string broken = check();
      if (!broken.empty()) return broken;
    }
    return "";
  }

 private:
  [[nodiscard]] bool chance(unsigned one_in) { return random_() % one_in == 0; }
  void press(bool on) {
    pressed_ = on;
    station_.host(on, now_);
    changed_ = now_;
    received_since_ = false;
  }
  void say() {
    const ReceivedStop said = station_.said(now_);
    sent_.push_back(said);
    if (random_() % 10 < 3) return;  // lost
    under_way_.push_back({now_ + milliseconds(random_() % 80), said, true});
    if (chance(5)) under_way_.push_back({now_ + milliseconds(random_() % 300), said, true});
  }
  void forge() {
    ReceivedStop forged = sent_.empty() ? station_.said(now_) : sent_[random_() % sent_.size()];
    if (chance(2)) {
      forged.value.stands = false;
      forged.value.number = random_();
      forged.value.keys = forged.value.locks;
      forged.value.locks.clear();
    }
    under_way_.push_back({now_, forged, false});
  }
  /// Of the vehicle's router, or of the station's.
  void restart() {
    if (chance(2)) {
      StopListener successor;
      successor.restore(vehicle_.memory(), now_);
      vehicle_ = successor;
      return;
    }
    StationSide successor(1);
    successor.number = station_.number;
    successor.speaker.restore(station_.speaker.presses());
    station_.speaker = StopSpeaker([this] {
      StopToken key{};
      for (std::uint8_t& byte : key) byte = static_cast<std::uint8_t>(random_());
      return key;
    });
    station_.speaker.restore(successor.speaker.presses());
    if (pressed_) station_.host(true, now_);
  }
  void deliver() {
    for (auto it = under_way_.begin(); it != under_way_.end();) {
      if (it->at > now_) {
        ++it;
        continue;
      }
      it->value.received = now_;
      if (it->honest && it->value.value.stands && pressed_ && it->value.value.number > 0 &&
          it->value.value.locks == station_.said(now_).value.locks) {
        received_since_ = true;
      }
      vehicle_.on_value(it->value);
      it = under_way_.erase(it);
    }
    vehicle_.follow(now_);
    station_.speaker.on_report(vehicle_.locks(), now_);
  }
  [[nodiscard]] std::string check() const {
    if (pressed_ && received_since_ && !vehicle_.stands()) return "a stop that was received ended";
    return "";
  }

  struct Packet {
    Time at;
    ReceivedStop value;
    bool honest;
  };
  std::mt19937_64 random_;
  StationSide station_{1};
  StopListener vehicle_;
  std::vector<ReceivedStop> sent_;
  std::vector<Packet> under_way_;
  bool pressed_ = false;
  bool received_since_ = false;
  Time changed_{};
  Time now_ = Time(seconds(1000));
};

TEST(StopRuns, NothingEndsAStopThatWasReceivedButItsOwnRelease) {
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    ASSERT_EQ(StopRun(seed).run(), "") << "seed " << seed;
  }
}

}  // namespace
}  // namespace tocsin::router
