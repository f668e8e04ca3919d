// SPDX-License-Identifier: Apache-2.0
#include "simulated_base.hpp"

#include <algorithm>

namespace tocsin::kobuki {

void SimulatedBase::receive(ByteView bytes, Time now) {
  if (plugged(now)) model_.receive(bytes, now);
}

void SimulatedBase::step(Time now, const SerialLine::Sink& sink) {
  model_.step(now, [&](Time sent, ByteView frame) {
    if (plugged(sent) && sent >= silent_until_) line_.send(frame, sent);
  });
  if (plugged(now)) line_.deliver(now, sink);
}

Time SimulatedBase::next_event() const {
  return std::min(model_.next_frame(), line_.next_delivery());
}

void SimulatedBase::unplug(Time now, Duration duration) {
  plug_at_ = duration > never - now ? never : now + duration;
  line_.clear();
}

void SimulatedBase::power_cycle(Time now) {
  model_.power_cycle(now);
  line_.clear();
  silence(now, std::chrono::seconds(1));
}

}  // namespace tocsin::kobuki
