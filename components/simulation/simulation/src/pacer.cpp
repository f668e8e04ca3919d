// SPDX-License-Identifier: Apache-2.0
#include "pacer.hpp"

#include <algorithm>
#include <map>
#include <string>

namespace tocsin::simulation {
namespace {

rtps::FlowController::Settings settings_of(const FlowController& controller) {
  static const std::map<std::string, rtps::Schedule> schedules{
      {"fifo", rtps::Schedule::fifo},
      {"round_robin", rtps::Schedule::round_robin},
      {"high_priority", rtps::Schedule::high_priority},
      {"priority_with_reservation", rtps::Schedule::priority_with_reservation}};
  return {schedules.at(controller.scheduler),
          static_cast<std::size_t>(controller.max_bytes_per_period), seconds(controller.period_s)};
}

/// As RTPSWriter::getMaxDataSize: what a message of a period's length has room for.
std::size_t fragment_bytes_of(const FlowController& controller) {
  constexpr std::size_t around = rtps::wire::longest_message - rtps::wire::largest_payload;
  const auto period = static_cast<std::size_t>(controller.max_bytes_per_period);
  return (std::min(period, rtps::wire::longest_message) - around) / 4 * 4;
}

}  // namespace

Pacer::Pacer(Core& core, const FlowController& settings)
    : core_(core),
      fragment_bytes_(fragment_bytes_of(settings)),
      controller_(settings_of(settings), core.now),
      alarm_(
          core, [this] { return controller_.next_event(); }, [this] { run(); }) {}

std::size_t Pacer::add(PacedWriter& writer, const QosProfile& qos) {
  writers_.push_back(&writer);
  return controller_.add_writer({qos.priority, qos.bandwidth_reservation_percent});
}

void Pacer::enqueue(const rtps::FlowController::Entry& entry, bool resent) {
  controller_.add(entry, resent);
}

void Pacer::run() {
  PacedWriter* current = nullptr;
  controller_.run(core_.now,
                  [&](const rtps::FlowController::Entry& entry, rtps::ByteBudget& budget) {
                    PacedWriter* const writer = writers_[entry.writer];
                    if (current != nullptr && current != writer) current->end_turn();
                    current = writer;
                    return writer->deliver(entry.sequence, budget);
                  });
  if (current != nullptr) current->end_turn();
  alarm_.update();
}

}  // namespace tocsin::simulation
