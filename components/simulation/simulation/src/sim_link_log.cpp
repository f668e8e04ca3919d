// SPDX-License-Identifier: Apache-2.0
// What the log of a simulated router keeps of samples.
#include <algorithm>
#include <cstring>

#include "sim_link_bus.hpp"

namespace tocsin::simulation {

std::vector<std::uint8_t> SimLinkBus::bytes_of(const CarriedSample& sample) const {
  const std::uint64_t number = network_.logged.size();
  network_.logged.push_back(sample.content);
  const auto& cargo = *static_cast<const Freight*>(sample.content.get());
  if (network_.observer() != nullptr && cargo.from != nullptr) {
    network_.observer()->on_logged({*cargo.from, network_.core.now, cargo.written, sample.source});
  }
  std::vector<std::uint8_t> bytes(std::max<std::size_t>(sample.bytes, sizeof number));
  std::memcpy(bytes.data(), &number, sizeof number);
  return bytes;
}

CarriedSample SimLinkBus::sample_of(std::vector<std::uint8_t> bytes) const {
  std::uint64_t number = 0;
  if (bytes.size() < sizeof number) return {};
  std::memcpy(&number, bytes.data(), sizeof number);
  if (number >= network_.logged.size()) return {};
  return {network_.logged[number], static_cast<std::uint32_t>(bytes.size())};
}

}  // namespace tocsin::simulation
