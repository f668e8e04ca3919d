// SPDX-License-Identifier: Apache-2.0
#include "fast_dds_v2/key_repeats.hpp"

#include <algorithm>

namespace tocsin {

void KeyRepeats::sent(Packet packet, Time now) {
  const Key key{packet.to, packet.bytes.size() >= least_key_bytes};
  if (last_.size() >= most_packets && last_.count(key) == 0) return;
  last_.insert_or_assign(key, Last{std::move(packet.bytes), RepeatTimes(now)});
}

std::optional<KeyRepeats::Packet> KeyRepeats::take_due(Time now) {
  const auto due = std::find_if(last_.begin(), last_.end(), [now](const auto& entry) {
    return now >= entry.second.times.next();
  });
  if (due == last_.end()) return std::nullopt;
  Last& last = due->second;
  Packet packet{last.bytes, due->first.first};
  if (!last.times.repeat(now)) last_.erase(due);
  return packet;
}

Time KeyRepeats::deadline() const {
  Time next = never;
  for (const auto& entry : last_) next = std::min(next, entry.second.times.next());
  return next;
}

}  // namespace tocsin
