// SPDX-License-Identifier: Apache-2.0
#include "vehicle_stop.hpp"

#include <limits>
#include <utility>

#include "foundation/printable.hpp"

namespace tocsin {

VehicleStop::VehicleStop(Component& owner, const StopKeysFile::Content& kept, Time now)
    : safety_(owner), request_(owner) {
  if (!kept.stands) return;
  router::StopListener::Memory memory;
  for (const auto& one : kept.tokens) memory.locks.push_back(one.token);
  memory.more = kept.others;
  listener_.restore(memory, now);
}

void VehicleStop::take(const StopNews& news, Time now) {
  for (const ReceivedStop& one : news.values) listener_.on_value(one);
  for (const ReceivedPacket& one : news.packets) listener_.on_packet(one);
  while (const auto request = request_.take()) {
    if (!request->data()) listener_.release_left(now);
  }
  if (auto status = safety_.take_latest()) status_ = std::move(status);
  listener_.follow(now);
}

void VehicleStop::fill(StopValue& value, Time) {
  value.locks = listener_.locks();
  value.known = status_ != nullptr;
  value.stands = status_ && status_->emergency_stop();
  value.by.clear();
  if (value.stands) value.by.assign(status_->stopped_by().begin(), status_->stopped_by().end());
}

void VehicleStop::fill(topic::LinkStop::Message& message, Time now) {
  message.stands(listener_.stands());
  for (const std::string& name : listener_.stopped_by()) {
    message.stopped_by().push_back(printable(name, 64));
  }
  message.releases(listener_.releases());
  const auto silence = listener_.silence(now);
  message.silence_s(silence ? to_seconds(*silence) : std::numeric_limits<double>::quiet_NaN());
}

StopKeysFile::Content VehicleStop::kept() const {
  const auto memory = listener_.memory();
  StopKeysFile::Content content{!memory.locks.empty() || memory.more, memory.more, {}};
  if (memory.locks.size() > StopKeysFile::most_tokens) content.others = true;
  for (const StopToken& lock : memory.locks) content.tokens.push_back({lock, false});
  return content;
}

}  // namespace tocsin
