// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/gated_writer.hpp"

#include <utility>

namespace tocsin {

GatedWriter::GatedWriter(std::string topic, const TrafficRule& rule,
                         std::unique_ptr<LinkWriter> writer, Freshness freshness)
    : sends_(writer != nullptr),
      writer_(std::move(writer)),
      while_poor_(rule.while_poor),
      silent_(writer_ == nullptr),
      freshness_(std::move(freshness)) {
  traffic_.topic = std::move(topic);
  traffic_.traffic_class = rule.traffic_class;
}

Status GatedWriter::keep(const std::shared_ptr<const void>& message) {
  if (while_poor_ == WhilePoor::drop) {
    ++traffic_.dropped;
  } else {
    if (kept_) ++traffic_.held;
    kept_ = message;
    if (freshness_.now) kept_at_ = freshness_.now();
  }
  return Status::paused;
}

void GatedWriter::send_kept() {
  const auto message = std::exchange(kept_, nullptr);
  if (!message) return;
  if (freshness_.now && freshness_.now() - kept_at_ > freshness_.lifespan) {
    ++traffic_.dropped;
  } else {
    (void)send(message.get());  // a refusal shows in `written` against `sent`
  }
}

void GatedWriter::set_open(bool open) {
  if (while_poor_ == WhilePoor::send) return;
  // At once, so that a writer that never pauses soon leaves the turn to this.
  if (!open) sends_.store(false, std::memory_order_relaxed);
  const std::lock_guard<TurnLock> lock(turn_);
  open_ = open;
  settle();
}

void GatedWriter::connect(std::unique_ptr<LinkWriter> writer) {
  const std::lock_guard<TurnLock> lock(turn_);
  writer_ = std::move(writer);
  settle();
}

void GatedWriter::settle() {
  const bool sends = open_ && writer_ != nullptr;
  sends_.store(sends, std::memory_order_relaxed);
  if (std::exchange(silent_, !sends) == !sends) return;
  if (sends) {
    send_kept();
  } else {
    writer_->silence();
  }
}

TopicTraffic GatedWriter::traffic() const {
  const std::lock_guard<TurnLock> lock(turn_);
  TopicTraffic now = traffic_;
  now.paused = silent_;
  return now;
}

}  // namespace tocsin
