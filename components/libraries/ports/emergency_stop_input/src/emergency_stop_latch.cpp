// SPDX-License-Identifier: Apache-2.0
#include "emergency_stop_input/emergency_stop_latch.hpp"

#include <iterator>

namespace tocsin {

void EmergencyStopLatch::press(const Writer& writer) {
  if (writer.station) {
    station_ = true;
    others_.erase(writer.id);  // its first word may come before it is known whose it is
  } else if (others_.count(writer.id) != 0 || others_.size() < most_writers) {
    others_[writer.id] = writer.name;
  } else {
    left_ = true;
  }
}

void EmergencyStopLatch::release(const Writer& writer, const IsThere& is_there) {
  others_.erase(writer.id);
  if (!writer.station) return;
  station_ = false;
  left_ = false;
  for (auto one = others_.begin(); one != others_.end();) {
    one = is_there(one->first) ? std::next(one) : others_.erase(one);
  }
}

std::optional<std::string> EmergencyStopLatch::name_of(std::uint64_t id) const {
  const auto found = others_.find(id);
  return found == others_.end() ? std::nullopt : std::optional(found->second);
}

void EmergencyStopLatch::restore(const Memory& memory) {
  station_ = station_ || memory.station;
  left_ = left_ || memory.others;
}

std::vector<std::string> EmergencyStopLatch::others() const {
  std::vector<std::string> all;
  for (const auto& one : others_) all.push_back(one.second);
  if (left_) all.emplace_back("a writer that is not known any more");
  return all;
}

}  // namespace tocsin
