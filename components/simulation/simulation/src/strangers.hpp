// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "sim_host.hpp"

namespace tocsin::simulation {

/// A person at the ground station with `tocsin estop`: presses and releases, and asks again until
/// the station and the vehicle do what was asked for.
class Person final : private Receiver {
 public:
  /// The process outlives the person.
  explicit Person(SimProcess& process);
  /// Several stops may overlap: pressed until each is released.
  void press();
  void release();
  /// Asks for what is wanted, unless the station has confirmed it.
  void ask();

 private:
  void receive(const Sample& sample) override;
  [[nodiscard]] bool is_pressed() const { return presses_ > 0; }
  int presses_ = 0;
  bool confirmed_ = false;
  std::unique_ptr<Publication> request_;
  std::unique_ptr<Subscription> state_;
};

/// Somebody on a host who publishes a velocity for the base, besides the components that may.
class Rogue {
 public:
  void begin(SimProcess& process);
  /// Publishes 0.5 m/s once.
  void drive();
  /// Its process is gone.
  void end();

 private:
  SimProcess* process_ = nullptr;
  std::unique_ptr<Publication> velocity_;
};

}  // namespace tocsin::simulation
