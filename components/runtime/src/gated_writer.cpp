// SPDX-License-Identifier: Apache-2.0
#include "runtime/middleware/gated_writer.hpp"

#include <utility>

namespace tocsin {
namespace {

/// Not a member: a member of a shared library is called through a table, which this path feels.
Status send(LinkWriter& writer, TopicTraffic& traffic, const void* message) {
  const std::size_t bytes = writer.send(message);
  if (bytes == 0) return Status::failed;
  ++traffic.sent;
  traffic.sent_bytes += bytes;
  return Status::ok;
}

}  // namespace

GatedWriter::GatedWriter(std::string topic, const TrafficRule& rule,
                         std::unique_ptr<LinkWriter> writer, Freshness freshness)
    : while_poor_(rule.while_poor), writer_(std::move(writer)), freshness_(std::move(freshness)) {
  traffic_.topic = std::move(topic);
  traffic_.traffic_class = rule.traffic_class;
}

Status GatedWriter::write(const std::shared_ptr<const void>& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++traffic_.written;
  return open_ ? send(*writer_, traffic_, message.get()) : keep(message);
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
    (void)send(*writer_, traffic_, message.get());  // a refusal shows in `written` against `sent`
  }
}

void GatedWriter::set_open(bool open) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (while_poor_ == WhilePoor::send || open == open_) return;
  open_ = open;
  if (!open) {
    writer_->silence();
  } else {
    send_kept();
  }
}

TopicTraffic GatedWriter::traffic() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  TopicTraffic now = traffic_;
  now.paused = !open_;
  return now;
}

}  // namespace tocsin
