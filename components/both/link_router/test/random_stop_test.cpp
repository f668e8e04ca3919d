// SPDX-License-Identifier: Apache-2.0
// Stops over a radio that loses and replays, with restarts, freezes and a forger.
// TOCSIN_STOP_RUNS=100000 in the environment makes so many runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include "link_router/stop_listener.hpp"
#include "station_side.hpp"

namespace tocsin::router {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// Ten seconds of a station that presses and releases, at 30 % loss, beside a forger who knows all
/// that was sent.
class StopRun {
 public:
  explicit StopRun(std::uint64_t seed) : random_(seed) {}

  /// What was promised and does not hold; empty: nothing.
  std::string run() {
    for (int step = 0; step < 400; ++step) {
      now_ += milliseconds(25);
      if (chance(60)) press(!pressed_);
      if (chance(100)) freeze(station_thaws_);
      if (chance(100)) freeze(vehicle_thaws_);
      if (now_ >= station_thaws_ && step % 4 == 0) say();
      if (chance(10)) forge();
      if (chance(60)) restart();
      if (now_ >= vehicle_thaws_) deliver();
      const std::string broken = check();
      if (!broken.empty()) return broken + " at step " + std::to_string(step);
    }
    return "";
  }

 private:
  struct Packet {
    Time at;
    ReceivedStop value;
  };
  [[nodiscard]] bool chance(unsigned one_in) { return random_() % one_in == 0; }

  void press(bool on) {
    pressed_ = on;
    host_changed_ = now_;
    received_ = false;
  }
  void freeze(Time& thaws) {
    constexpr std::array<int, 3> lengths_ms{1000, 2000, 5000};
    thaws = now_ + milliseconds(lengths_ms[random_() % lengths_ms.size()]);
  }
  void say() {
    station_.host(pressed_, now_);
    const ReceivedStop said = station_.said(now_);
    sent_.push_back(said);
    if (random_() % 10 < 3) return;  // lost
    under_way_.push_back({now_ + milliseconds(random_() % 80), said});
    if (chance(5)) under_way_.push_back({now_ + milliseconds(random_() % 300), said});
  }
  /// A recorded value, or the release of a recorded press by who has no key of it.
  void forge() {
    if (sent_.empty()) return;
    ReceivedStop forged = sent_[random_() % sent_.size()];
    if (chance(2)) {
      forged.value.stands = false;
      forged.value.number = random_();
      for (const StopToken& lock : forged.value.locks) forged.value.keys.push_back(lock);
      forged.value.locks.clear();
    } else if (forged.value.stands) {
      forged_at_ = now_;
    }
    under_way_.push_back({now_, forged});
  }
  /// Of the vehicle's router, or of the station's: each has a file.
  void restart() {
    if (chance(2)) {
      StopListener successor;
      successor.restore(vehicle_.memory(), now_);
      vehicle_ = successor;
      return;
    }
    const auto presses = station_.speaker.presses();
    const bool stood = !presses.empty() && !presses.back().released;
    station_.speaker = StopSpeaker([this] {
      StopToken key{};
      for (std::uint8_t& byte : key) byte = static_cast<std::uint8_t>(random_());
      return key;
    });
    station_.speaker.restore(presses);
    if (stood) station_.host(true, now_);
  }
  void deliver() {
    const auto due = std::stable_partition(under_way_.begin(), under_way_.end(),
                                           [&](const Packet& one) { return one.at > now_; });
    for (auto it = due; it != under_way_.end(); ++it) {
      it->value.received = now_;
      const auto& locks = it->value.value.locks;
      const auto own = station_.said(now_).value.locks;
      received_ = received_ || (pressed_ && !own.empty() && locks == own);
      vehicle_.on_value(it->value);
    }
    under_way_.erase(due, under_way_.end());
    vehicle_.follow(now_);
    if (now_ >= station_thaws_) station_.speaker.on_report(vehicle_.locks(), now_);
  }
  /// Both run, and have run for so long.
  [[nodiscard]] bool undisturbed(Duration time) const {
    return now_ - time >= std::max({station_thaws_, vehicle_thaws_, host_changed_});
  }
  [[nodiscard]] std::string check() const {
    if (pressed_ && received_ && !vehicle_.stands()) return "a stop that was received ended";
    if (pressed_ && undisturbed(seconds(2)) && !vehicle_.stands()) {
      return "a press was not received within 2 s";
    }
    const bool forged = now_ - forged_at_ < seconds(2);
    if (!pressed_ && undisturbed(seconds(4)) && !forged && vehicle_.stands()) {
      return "a release was not received within 4 s";
    }
    return "";
  }

  std::mt19937_64 random_;
  StationSide station_{1};
  StopListener vehicle_;
  std::vector<ReceivedStop> sent_;
  std::vector<Packet> under_way_;
  bool pressed_ = false;
  bool received_ = false;  ///< what the host presses now
  Time now_ = Time(seconds(1000));
  Time host_changed_ = now_;
  Time station_thaws_ = now_;
  Time vehicle_thaws_ = now_;
  Time forged_at_{};
};

TEST(StopRuns, NothingSilencesAStopNorEndsItButItsOwnRelease) {
  const char* const wanted = std::getenv("TOCSIN_STOP_RUNS");
  const std::uint64_t runs = wanted == nullptr ? 500 : std::stoull(wanted);
  for (std::uint64_t seed = 1; seed <= runs; ++seed) {
    ASSERT_EQ(StopRun(seed).run(), "") << "seed " << seed;
  }
}

}  // namespace
}  // namespace tocsin::router
