// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "emergency_stop_input/emergency_stop_latch.hpp"
#include "emergency_stop_input/link_stop_view.hpp"
#include "emergency_stop_input/stop_file.hpp"
#include "runtime/component.hpp"
#include "runtime/port.hpp"
#include "tocsin_idl/topics.hpp"

namespace tocsin {

/// Member of a component that obeys the emergency stop: its two ports, and what stands.
///
/// A stop stands when one of this host's writers of topic::EmergencyStop has pressed it, by the
/// rule of EmergencyStopLatch, or when the link says so, by the rule of LinkStopView. A release by
/// people at the station ends what local writers have left that have gone.
///
/// The owner calls `take` in each tick and asks to be woken at `deadline`.
class EmergencyStopInput {
 public:
  explicit EmergencyStopInput(Component& owner) : input_(owner), link_input_(owner) {}

  /// Takes what has been received until `now`. True when what stands, or by whom, has changed.
  [[nodiscard]] bool take(Time now);
  /// As of the last `take`.
  [[nodiscard]] bool stands() const { return stands_; }
  /// Whose stops stand, as SafetyStatus reports it; the station first.
  [[nodiscard]] const std::vector<std::string>& stopped_by() const { return stopped_by_; }
  /// When to call `take` though nothing is received.
  [[nodiscard]] Time deadline() const { return deadline_; }
  /// For the successor of this process, and what one before it has kept.
  [[nodiscard]] StopMemory memory() const { return {latch_.memory(), link_memory_}; }
  void restore(const StopMemory& memory, Time now);

 private:
  [[nodiscard]] EmergencyStopLatch::Writer writer(std::uint64_t source) const;
  [[nodiscard]] bool take_local();
  [[nodiscard]] bool take_link(Time now);
  void release(const EmergencyStopLatch::Writer& writer);
  [[nodiscard]] std::vector<std::string> names(Time now) const;
  [[nodiscard]] bool update(Time now);

  OptionalInput<topic::EmergencyStop> input_;
  OptionalInput<topic::LinkStop> link_input_;
  EmergencyStopLatch latch_;
  LinkStopView link_;
  // As of the last `take`.
  bool stands_ = false;
  LinkStopView::Memory link_memory_;
  std::vector<std::string> stopped_by_;
  Time deadline_ = never;
};

}  // namespace tocsin
