// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "emergency_stop_input/emergency_stop_latch.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Member of a component that obeys the emergency stop: its port, and what stands by the rule of
/// EmergencyStopLatch.
class EmergencyStopInput {
 public:
  explicit EmergencyStopInput(Component& owner) : input_(owner) {}

  /// Takes what has come. True when something had, whether or not it changed anything.
  bool take();
  [[nodiscard]] bool stands() const { return latch_.stands(); }
  /// Whose stops stand, as SafetyStatus tells it.
  [[nodiscard]] std::vector<std::string> stopped_by() const;
  /// For the successor of this process, and what one before it has kept.
  [[nodiscard]] EmergencyStopLatch::Memory memory() const { return latch_.memory(); }
  void restore(const EmergencyStopLatch::Memory& memory) { latch_.restore(memory); }

 private:
  [[nodiscard]] EmergencyStopLatch::Writer writer(std::uint64_t source) const;
  Input<topic::EmergencyStop> input_;
  EmergencyStopLatch latch_;
};

}  // namespace tocsin
