// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/rtps/common/Locator.h>

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "link/message_pieces.hpp"
#include "rtps_filter/rtps_filter.hpp"

namespace tocsin {

/// Where a participant is, as far as the filter of its packets must know.
struct Surroundings {
  std::string address;             ///< IPv4 of its interface
  std::vector<std::string> peers;  ///< IPv4 that it may speak with
  bool radio = false;              ///< nobody but the peers is heard
};
/// What a participant is shown there: on the radio, packets of its peers only; on the host, those
/// of all. Locators of others than these, of the computer itself on the host, are not answered.
[[nodiscard]] rtps_filter::Limits limits_in(const Surroundings& surroundings);

/// Shows a participant what the filter lets through, and counts the rest (`dropped_packets`). Any
/// thread.
class PacketFilter {
 public:
  explicit PacketFilter(rtps_filter::Limits limits)
      : secured_(limits.secured), filter_(std::move(limits)) {}

  /// Calls `show(bytes, size)` with the packet, or a copy without what must not be read, and before
  /// it with an announcement that it completes; or does not.
  template <class Show>
  void pass(const std::uint8_t* bytes, std::size_t size,
            const eprosima::fastrtps::rtps::Locator_t& from, Show show) {
    const rtps_filter::Inspection inspection = inspect(bytes, size, from);
    if (inspection.drop) return;
    if (secured_) {
      const auto assembled = assemble(bytes, size, from);
      if (assembled.whole) pass(assembled.whole->data(), assembled.whole->size(), from, show);
      if (assembled.piece) return;
    }
    if (!inspection.before.empty()) show(inspection.before.data(), inspection.before.size());
    if (inspection.strip.empty() && inspection.hide.empty()) return show(bytes, size);
    const std::vector<std::uint8_t> shown = without(bytes, size, inspection);
    show(shown.data(), shown.size());
  }

 private:
  rtps_filter::Inspection inspect(const std::uint8_t* bytes, std::size_t size,
                                  const eprosima::fastrtps::rtps::Locator_t& from);
  static std::vector<std::uint8_t> without(const std::uint8_t* bytes, std::size_t size,
                                           const rtps_filter::Inspection& inspection);
  PieceAssembly::Result assemble(const std::uint8_t* bytes, std::size_t size,
                                 const eprosima::fastrtps::rtps::Locator_t& from);
  const bool secured_;
  std::mutex mutex_;
  rtps_filter::RtpsFilter filter_;
  PieceAssembly pieces_;
};

}  // namespace tocsin
