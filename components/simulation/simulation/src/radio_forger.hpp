// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <deque>
#include <random>

#include "sim_link_bus.hpp"

namespace tocsin::simulation {

/// Somebody on a plain link who hears every packet and speaks in each router's name, without any
/// of their secrets: releases stops, repeats what was said of them before, and sends transmissions
/// that it has just heard again, under numbers and times of its own.
class RadioForger {
 public:
  RadioForger(Network& network, std::uint64_t seed) : network_(network), random_(seed) {}
  RadioForger(const RadioForger&) = delete;
  RadioForger& operator=(const RadioForger&) = delete;
  ~RadioForger() { end(); }

  /// Listens from now on.
  void begin();
  /// Sends one packet of each kind to each router that it has heard of.
  void speak();
  void end();

 private:
  struct Heard {
    Time at;
    Overheard what;
  };
  void hear(const Overheard& what);
  void speak_to(SimLinkBus& victim, const SimLinkBus& peer);
  void say_of_stop(SimLinkBus& victim, PeerId peer);
  void send_again(SimLinkBus& victim, PeerId peer);

  Network& network_;
  std::mt19937_64 random_;
  std::deque<Heard> heard_;
};

}  // namespace tocsin::simulation
