// SPDX-License-Identifier: Apache-2.0
#include "rtps.hpp"

#include <utility>

#include "best_effort.hpp"
#include "reliable.hpp"

namespace tocsin::simulation {
namespace {

/// What a gate hands back that is not the object of the last write.
std::shared_ptr<const void> copy_of(const TypeInfo& type, const void* message, std::size_t size) {
  std::vector<std::uint8_t> cdr(size);
  if (type.serialize(message, cdr.data(), cdr.size()) == 0) return nullptr;
  std::shared_ptr<void> copy = type.create();
  return type.deserialize(cdr.data(), cdr.size(), copy.get()) ? copy : nullptr;
}

}  // namespace

std::unique_ptr<RtpsWriter> RtpsWriter::make(Core& core, RadioLink& link, const Owner& owner,
                                             const QosProfile& qos, Pacer* pacer) {
  if (qos.reliable()) return std::make_unique<ReliableWriter>(core, link, owner, qos, pacer);
  return std::make_unique<BestEffortWriter>(core, link, owner, qos, pacer);
}

std::size_t RtpsWriter::send(const void* message) {
  const TypeInfo& type = *owner_.end->type;
  const bool known = owner_.origin->message.get() == message;
  Change change{next_sequence(), core_.now, nullptr,   type.serialized_size(message),
                owner_.end,      0,         core_.now, 0};
  change.message = known ? owner_.origin->message : copy_of(type, message, change.bytes);
  if (!change.message) return 0;
  change.sent_wall_ns = owner_.wall_ns(core_.now);
  if (known) {
    change.written = owner_.origin->sequence;
    change.written_at = owner_.origin->time;
  }
  const std::size_t bytes = change.bytes;
  return publish(std::move(change)) ? bytes : 0;
}

void RtpsWriter::tell_observer(const Change& change) const {
  if (core_.observer == nullptr) return;
  core_.observer->on_sent({*owner_.end, core_.now, change.sequence, change.written, change.bytes});
}

std::unique_ptr<RtpsReader> RtpsReader::make(Core& core, RadioLink& link, const QosProfile& qos,
                                             Deliver deliver) {
  if (qos.reliable()) return std::make_unique<ReliableReader>(core, link, qos, std::move(deliver));
  return std::make_unique<BestEffortReader>(core, qos, std::move(deliver));
}

}  // namespace tocsin::simulation
