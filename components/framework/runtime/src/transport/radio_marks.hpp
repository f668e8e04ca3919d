// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fastdds/rtps/common/EntityId_t.hpp>

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>

#include "runtime/middleware/link_bus.hpp"

namespace tocsin {

/// Which differentiated services code point (RFC 2474) the packets of an endpoint bear, and how
/// many were sent. Discovery and what is not known bear CS6: little, and all else depends on it.
/// Thread-safe.
class RadioMarks {
 public:
  static constexpr int network_control = 48;  ///< CS6 (RFC 4594 section 3.1)

  /// The flow of a writer.
  struct Mark {
    int dscp = 0;  ///< [0, 63]
    TrafficClass traffic_class = TrafficClass::normal;
    LinkPurpose purpose = LinkPurpose::samples;
  };
  /// Its bytes are counted by class and purpose.
  void set(const eprosima::fastrtps::rtps::EntityId_t& endpoint, const Mark& mark);
  void forget(const eprosima::fastrtps::rtps::EntityId_t& endpoint);
  /// Notes a packet of `sent` bytes, with the message or a piece of it, and returns its code point.
  [[nodiscard]] int mark(const std::uint8_t* message, std::size_t size, std::size_t sent);
  /// The same for a packet that holds a value of the emergency stop alone.
  [[nodiscard]] int mark_stop(std::size_t sent);
  /// Notes such a value of `bytes` in a packet that was marked.
  void note_rider(std::size_t bytes);
  [[nodiscard]] LinkPackets packets() const;

 private:
  using Endpoint = eprosima::fastrtps::rtps::EntityId_t;
  mutable std::mutex mutex_;
  std::map<Endpoint, Mark> marks_;
  LinkPackets packets_;
};

}  // namespace tocsin
