// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "runtime/fast_dds/names.hpp"

#if TOCSIN_FAST_DDS >= 3
#include <fastdds/rtps/transport/ChainingTransport.hpp>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.hpp>
#include <fastdds/rtps/transport/SenderResource.hpp>
#include <fastdds/rtps/transport/TransportInterface.hpp>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.hpp>
#else
#include <fastdds/rtps/network/SenderResource.h>
#include <fastdds/rtps/transport/ChainingTransport.h>
#include <fastdds/rtps/transport/ChainingTransportDescriptor.h>
#include <fastdds/rtps/transport/TransportInterface.h>
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>
#endif

namespace tocsin::fast_dds {

namespace rtps = eprosima::fastdds::rtps;
using SendUntil = std::chrono::steady_clock::time_point;

#if TOCSIN_FAST_DDS >= 3

/// The buffers as one; in `memory` unless there is one only.
[[nodiscard]] inline const std::uint8_t* gathered(const std::vector<rtps::NetworkBuffer>& buffers,
                                                  std::uint32_t size,
                                                  std::vector<std::uint8_t>& memory) {
  if (buffers.size() == 1) return static_cast<const std::uint8_t*>(buffers.front().buffer);
  memory.resize(size);
  std::size_t at = 0;
  for (const rtps::NetworkBuffer& one : buffers) {
    std::memcpy(memory.data() + at, one.buffer, one.size);
    at += one.size;
  }
  return memory.data();
}

#endif

/// Sends whole RTPS messages over UDP.
class PacketSender : public rtps::SenderResource {
 protected:
  PacketSender() : SenderResource(LOCATOR_KIND_UDPv4) {
#if TOCSIN_FAST_DDS >= 3
    send_buffers_lambda_ = [this](const std::vector<rtps::NetworkBuffer>& buffers,
                                  std::uint32_t size, rtps::LocatorsIterator* first,
                                  rtps::LocatorsIterator* last, const SendUntil&) {
      thread_local std::vector<std::uint8_t> memory;
      return send_packet(gathered(buffers, size, memory), size, *first, *last);
    };
#else
    send_lambda_ = [this](const std::uint8_t* bytes, std::uint32_t size,
                          rtps::LocatorsIterator* first, rtps::LocatorsIterator* last,
                          const SendUntil&) { return send_packet(bytes, size, *first, *last); };
#endif
  }
  /// To all from `next` on. Any thread.
  virtual bool send_packet(const std::uint8_t* bytes, std::uint32_t size,
                           rtps::LocatorsIterator& next, const rtps::LocatorsIterator& last) = 0;
};

/// Sends by its channels, without the transport below.
class PacketTransport : public rtps::ChainingTransport {
 public:
  using ChainingTransport::ChainingTransport;
  // NOLINTBEGIN(readability-function-size): the signatures are those of Fast DDS
#if TOCSIN_FAST_DDS >= 3
  bool send(rtps::SenderResource* channel, const std::vector<rtps::NetworkBuffer>& buffers,
            std::uint32_t size, rtps::LocatorsIterator* first, rtps::LocatorsIterator* last,
            const SendUntil& timeout) override {
    return channel->send(buffers, size, first, last, timeout);
  }
#else
  bool send(rtps::SenderResource* channel, const rtps::octet* bytes, std::uint32_t size,
            rtps::LocatorsIterator* first, rtps::LocatorsIterator* last,
            const SendUntil& timeout) override {
    return channel->send(bytes, size, first, last, timeout);
  }
#endif
  // NOLINTEND(readability-function-size)

#if TOCSIN_FAST_DDS >= 3
  bool transform_remote_locator(const rtps::Locator_t& remote, rtps::Locator_t& result,
                                bool /*loopback_there*/, bool /*loopback_here*/) const final {
    return reach(remote, result);
  }
#endif
  bool transform_remote_locator(const rtps::Locator_t& remote,
                                rtps::Locator_t& result) const final {
    return reach(remote, result);
  }

 protected:
  /// Where packets for a peer's locator go; false: nowhere.
  [[nodiscard]] virtual bool reach(const rtps::Locator_t& remote,
                                   rtps::Locator_t& result) const = 0;
  /// The same of the transport below.
  [[nodiscard]] bool reach_below(const rtps::Locator_t& remote, rtps::Locator_t& result) const {
#if TOCSIN_FAST_DDS >= 3
    constexpr bool loopback_will_do = true;
    return low_level_transport_->transform_remote_locator(remote, result, loopback_will_do,
                                                          loopback_will_do);
#else
    return low_level_transport_->transform_remote_locator(remote, result);
#endif
  }
};

}  // namespace tocsin::fast_dds
