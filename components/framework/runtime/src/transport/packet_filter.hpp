// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "fast_dds_v2/message_pieces.hpp"
#include "foundation/thread_cpu.hpp"
#include "rtps/other_vendors.hpp"
#include "rtps/writer_numbers.hpp"
#include "rtps_filter/rtps_filter.hpp"
#include "runtime/fast_dds/names.hpp"
#include "transport/sender_users.hpp"

namespace tocsin {

/// Where a participant is, as far as the filter of its packets must know.
struct Surroundings {
  std::string address;             ///< IPv4 of its interface
  std::vector<std::string> peers;  ///< IPv4 that it may speak with
  bool radio = false;              ///< nobody but the peers is heard
};
/// What a participant is shown there: on the radio, packets of its peers only, and their locators
/// only; on the host, all, since host_side sends to loopback whatever a locator says.
[[nodiscard]] rtps_filter::Limits limits_in(const Surroundings& surroundings);
/// Whether a packet from an address was sent on this computer: on the host always, on the radio
/// when it is our own address.
[[nodiscard]] std::function<bool(std::uint32_t address)> local_in(const Surroundings& surroundings);

/// Shows a participant what the filter lets through, and counts the rest (`dropped_packets`). Any
/// thread.
class PacketFilter {
 public:
  using IsLocal = std::function<bool(std::uint32_t address)>;

  /// `is_local`: whether an address is of this computer, so that it has users. `others`: is told of
  /// those whose packets pass, `numbers` of these packets; null: nobody is.
  explicit PacketFilter(rtps_filter::Limits limits, IsLocal is_local = {},
                        std::shared_ptr<OtherVendors> others = {},
                        std::shared_ptr<WriterNumbers> numbers = {})
      : secured_(limits.secured),
        is_local_(std::move(is_local)),
        others_(std::move(others)),
        numbers_(std::move(numbers)),
        filter_(std::move(limits)) {}

  /// RTPS 2.2 section 9.6.1.1. A participant reads announcements at the ports of discovery only.
  enum class Port { discovery, user_data };
  [[nodiscard]] static Port kind_of(std::uint32_t port) {
    return port % 2 == 0 ? Port::discovery : Port::user_data;
  }
  /// Calls `show(bytes, size)` with the packet that has come to a port `at` the participant, or a
  /// copy without what must not be read, and before it with announcements; or does not.
  template <class Show>
  void pass(const std::uint8_t* bytes, std::size_t size,
            const eprosima::fastdds::rtps::Locator_t& from, Port at, Show show) {
    const rtps_filter::Inspection inspection = inspect(bytes, size, from, at);
    if (inspection.drop) return;
    const JumpCost cost(*this, inspection.jumps);
    for (const auto& message : inspection.before) show(message.data(), message.size());
    if (secured_) {
      const auto assembled = assemble(bytes, size, from);
      if (assembled.whole) pass(assembled.whole->data(), assembled.whole->size(), from, at, show);
      if (assembled.piece) return;
    }
    if (inspection.strip.empty() && inspection.hide.empty() && inspection.step.empty()) {
      return show(bytes, size);
    }
    const std::vector<std::uint8_t> shown = rtps_filter::changed(bytes, size, inspection);
    show(shown.data(), shown.size());
  }

  /// What DDS Security has found out (RtpsFilter::authenticate, forget), or a peer's next instance
  /// (supersede). `participant`: GUID prefix.
  void authenticate(const eprosima::fastdds::rtps::GuidPrefix_t& participant);
  void forget(const eprosima::fastdds::rtps::GuidPrefix_t& participant);
  void supersede(const eprosima::fastdds::rtps::GuidPrefix_t& participant);
  /// Null where nobody is told.
  [[nodiscard]] const std::shared_ptr<OtherVendors>& others() const { return others_; }

 private:
  /// Tells the filter what a packet has cost, where it wants to know.
  class JumpCost {
   public:
    JumpCost(PacketFilter& filter, bool wanted)
        : filter_(wanted ? &filter : nullptr), begin_(wanted ? thread_cpu() : Duration{}) {}
    ~JumpCost() {
      if (filter_ != nullptr) filter_->took(thread_cpu() - begin_);
    }
    JumpCost(const JumpCost&) = delete;
    JumpCost& operator=(const JumpCost&) = delete;

   private:
    PacketFilter* const filter_;
    const Duration begin_;
  };
  void took(Duration cpu);
  rtps_filter::Inspection inspect(const std::uint8_t* bytes, std::size_t size,
                                  const eprosima::fastdds::rtps::Locator_t& from, Port at);
  PieceAssembly::Result assemble(const std::uint8_t* bytes, std::size_t size,
                                 const eprosima::fastdds::rtps::Locator_t& from);
  [[nodiscard]] rtps_filter::Sender sender(const rtps_filter::Source& source);

  const bool secured_;
  const IsLocal is_local_;
  const std::shared_ptr<OtherVendors> others_;
  const std::shared_ptr<WriterNumbers> numbers_;
  SenderUsers users_;
  std::mutex mutex_;
  rtps_filter::RtpsFilter filter_;
  PieceAssembly pieces_;
};

}  // namespace tocsin
