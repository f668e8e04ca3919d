// SPDX-License-Identifier: Apache-2.0
#include "radio_forger.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace tocsin::simulation {
namespace {

constexpr std::size_t most_heard = 64;
/// What is older was received, and would be late: its writer's promise is over.
constexpr Duration sends_again_within = std::chrono::milliseconds(100);

}  // namespace

void RadioForger::begin() {
  network_.on_air = [this](const Overheard& what) { hear(what); };
}

void RadioForger::end() {
  network_.on_air = nullptr;
  heard_.clear();
}

void RadioForger::hear(const Overheard& what) {
  heard_.push_back({network_.core.now, what});
  if (heard_.size() > most_heard) heard_.pop_front();
}

void RadioForger::speak() {
  // Whom it tells may die of it.
  const auto routers = network_.routers;
  for (const auto& victim : routers) {
    for (const auto& peer : routers) {
      if (victim.second != peer.second) speak_to(*victim.second, *peer.second);
    }
  }
}

void RadioForger::speak_to(SimLinkBus& victim, const SimLinkBus& peer) {
  say_of_stop(victim, peer.self());
  send_again(victim, peer.self());
}

void RadioForger::say_of_stop(SimLinkBus& victim, PeerId peer) {
  std::shared_ptr<const StopValue> said;
  for (const Heard& one : heard_) {
    if (one.what.from == peer && one.what.stop && random_() % 3 != 0) said = one.what.stop;
  }
  if (!said) return;
  auto forged = std::make_shared<StopValue>(*said);
  const std::array<std::uint64_t, 3> numbers{forged->number, forged->number + 1, ~0ULL};
  forged->number = numbers[random_() % numbers.size()];
  if (random_() % 2 == 0) {
    forged->stands = false;
    std::swap(forged->keys, forged->locks);
  }
  if (random_() % 3 == 0) forged->instance = random_();
  victim.on_packet(peer, forged);
}

void RadioForger::send_again(SimLinkBus& victim, PeerId peer) {
  for (const Heard& one : heard_) {
    const Overheard& what = one.what;
    if (what.from != peer || !what.flow || network_.core.now - one.at > sends_again_within)
      continue;
    const std::array<std::uint64_t, 4> numbers{what.number, what.number + 5, 1, 1ULL << 40U};
    const std::array<Duration, 4> ahead{Duration::zero(), std::chrono::milliseconds(400),
                                        std::chrono::hours(1), -std::chrono::hours(1)};
    Overheard forged = what;
    forged.sample.sent_wall_ns += ahead[random_() % ahead.size()].count();
    forged.number = numbers[random_() % numbers.size()];
    return victim.on_arrived(forged);
  }
}

}  // namespace tocsin::simulation
