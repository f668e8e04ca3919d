// SPDX-License-Identifier: Apache-2.0
#include "watch/dropped_packets.hpp"

#include <mutex>

namespace tocsin {
namespace {

/// Of the process, as Fast DDS's participants are: who tells of them does not make them.
struct Shared {
  std::mutex mutex;
  rtps_filter::DropAccount account;
};

Shared& shared() {
  static Shared instance;
  return instance;
}

}  // namespace

void count_dropped_packet(rtps_filter::DropReason reason, std::uint32_t address) {
  const std::lock_guard<std::mutex> lock(shared().mutex);
  shared().account.add(reason, address);
}

rtps_filter::DropAccount dropped_packets() {
  const std::lock_guard<std::mutex> lock(shared().mutex);
  return shared().account;
}

}  // namespace tocsin
