// SPDX-License-Identifier: Apache-2.0
#include "link_router/stop_listener.hpp"

#include <algorithm>
#include <utility>

#include "link_router/stop_speaker.hpp"

namespace tocsin::router {
namespace {

/// Routers of stations that are distinguished; of more the one that is silent for longest is
/// forgotten.
constexpr std::size_t most_stations = 16;
constexpr Duration remembered_for = std::chrono::seconds(10);
constexpr std::size_t most_identities = 64;

template <class List, class Value>
void add_once(List& list, const Value& value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(value);
}

}  // namespace

/// A recorded value is not fresh where numbers cannot be forged.
bool StopListener::is_fresh(const ReceivedStop& received) {
  if (received.identity.empty()) return true;
  if (numbers_.size() >= most_identities && numbers_.count(received.identity) == 0) return false;
  std::uint64_t& highest = numbers_[received.identity];
  if (received.value.number <= highest) return false;
  highest = received.value.number;
  return true;
}

void StopListener::on_value(const ReceivedStop& received) {
  if (received.value.role != Role::gcs) return;
  const bool fresh = is_fresh(received);
  if (received.value.stands) press(received);
  try_keys(received.value.keys);
  if (!fresh) return;
  if (!received.value.stands && !received.identity.empty()) release_by_identity(received);
  last_value_ = received.received;
  stale_.erase(std::remove(stale_.begin(), stale_.end(), received.value.host), stale_.end());
  const bool full = stations_.size() >= most_stations && stations_.count(received.router) == 0;
  if (full) {
    stations_.erase(std::min_element(
        stations_.begin(), stations_.end(),
        [](const auto& a, const auto& b) { return a.second.packet < b.second.packet; }));
  }
  stations_[received.router] = {received.value.host, received.received, received.received};
}

void StopListener::press(const ReceivedStop& received) {
  if (received.value.locks.empty()) {
    more_ = true;  // by whoever cannot release it
    return;
  }
  const StopToken& lock = received.value.locks.front();
  const auto found =
      std::find_if(stops_.begin(), stops_.end(), [&](const Stop& one) { return one.lock == lock; });
  if (found == stops_.end() && stops_.size() >= most_stops) {
    more_ = true;
    return;
  }
  Stop& stop = found == stops_.end() ? stops_.emplace_back() : *found;
  stop.lock = lock;
  stop.identity = received.identity;
  stop.number = std::max(stop.number, received.value.number);
  stop.by = received.value.by;
  if (stop.by.empty()) stop.by = {received.value.host};
  stop.said = received.received;
}

void StopListener::try_keys(const std::vector<StopToken>& keys) {
  if (stops_.empty()) return;
  for (const StopToken& key : keys) {
    const StopToken lock = lock_of(key);
    const auto ends = [&](const Stop& one) { return one.lock == lock; };
    stops_.erase(std::remove_if(stops_.begin(), stops_.end(), ends), stops_.end());
  }
}

void StopListener::release_by_identity(const ReceivedStop& received) {
  const auto ends = [&](const Stop& one) {
    return one.identity == received.identity && one.number < received.value.number;
  };
  const auto kept = std::remove_if(stops_.begin(), stops_.end(), ends);
  if (kept == stops_.end()) return;
  stops_.erase(kept, stops_.end());
  ++releases_;
}

void StopListener::on_packet(const ReceivedPacket& packet) {
  const auto found = stations_.find(packet.router);
  if (found == stations_.end()) return;
  found->second.packet = std::max(found->second.packet, packet.received);
}

void StopListener::follow(Time now) {
  if (watch_.begins(now)) begun_ = now;
  for (auto it = stations_.begin(); it != stations_.end();) {
    const Station& one = it->second;
    if (one.packet - one.value > fresh_for) add_once(stale_, one.host);
    it = now - one.packet > remembered_for ? stations_.erase(it) : std::next(it);
  }
}

void StopListener::release_left(Time now) {
  const auto left = [&](const Stop& one) { return now - one.said > received_for; };
  stops_.erase(std::remove_if(stops_.begin(), stops_.end(), left), stops_.end());
  more_ = false;
  stale_.clear();
  ++releases_;
}

bool StopListener::knows(Time now) const {
  return stands() || (last_value_ && *last_value_ >= begun_) || now - begun_ >= fresh_for;
}

bool StopListener::stands() const { return !stops_.empty() || more_ || !stale_.empty(); }

std::vector<std::string> StopListener::stopped_by() const {
  std::vector<std::string> names;
  for (const Stop& stop : stops_) {
    for (const std::string& name : stop.by) add_once(names, name);
  }
  if (more_) add_once(names, std::string("an unknown station"));
  for (const std::string& host : stale_) add_once(names, host + ": value not fresh");
  return names;
}

std::vector<StopToken> StopListener::locks() const {
  std::vector<StopToken> locks;
  for (const Stop& stop : stops_) {
    if (locks.size() < StopValue::most_tokens) locks.push_back(stop.lock);
  }
  return locks;
}

std::optional<Duration> StopListener::silence(Time now) const {
  return last_value_ ? std::optional<Duration>(now - *last_value_) : std::nullopt;
}

StopListener::Memory StopListener::memory() const {
  Memory memory;
  for (const Stop& stop : stops_) memory.locks.push_back(stop.lock);
  memory.more = more_;
  return memory;
}

void StopListener::restore(const Memory& memory, Time now) {
  for (const StopToken& lock : memory.locks) {
    if (stops_.size() < most_stops) stops_.push_back({lock, "", 0, {"before a restart"}, now});
  }
  more_ = memory.more;
}

}  // namespace tocsin::router
