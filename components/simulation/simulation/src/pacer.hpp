// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "alarm.hpp"
#include "rtps_model/flow_controller.hpp"
#include "rtps_model/message_group.hpp"
#include "runtime/middleware/qos_profile.hpp"

namespace tocsin::simulation {

/// A writer whose samples wait for their turn.
class PacedWriter {
 public:
  virtual ~PacedWriter() = default;
  /// Sends what is to be sent of a sample; false when the budget was over before.
  virtual bool deliver(rtps::Sequence sequence, rtps::ByteBudget& budget) = 0;
  /// Another writer's turn: what is packed leaves.
  virtual void end_turn() = 0;
};

/// A flow controller of config/qos.yaml in one process: in each period its writers send so many
/// bytes.
class Pacer {
 public:
  Pacer(Core& core, const FlowController& settings);

  /// The number of a new writer, which lives as long as the core.
  std::size_t add(PacedWriter& writer, const QosProfile& qos);
  void enqueue(const rtps::FlowController::Entry& entry, bool resent);
  void remove(std::size_t writer, rtps::Sequence sequence) { controller_.remove(writer, sequence); }
  /// Sends what may be sent now.
  void run();
  /// Longer samples are cut so that a piece fits a message and a period.
  [[nodiscard]] std::size_t fragment_bytes() const { return fragment_bytes_; }

 private:
  Core& core_;
  std::size_t fragment_bytes_;
  rtps::FlowController controller_;
  std::vector<PacedWriter*> writers_;
  Alarm alarm_;
};

}  // namespace tocsin::simulation
