// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <set>

#include "runtime/fast_dds/names.hpp"
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
    PathIndex path = 0;
  };
  /// How a packet goes: discovery and what is not known by every path.
  struct Way {
    int dscp = network_control;
    std::array<bool, most_paths> paths{true, false};
  };
  /// There is a second path.
  void add_path() { has_second_ = true; }
  /// What endpoints of `set` send does not go to these addresses from now on, in host byte order.
  void mute(std::set<std::uint32_t> addresses);
  /// Whether the message does not go to an address for that.
  [[nodiscard]] bool withholds(const std::uint8_t* message, std::size_t size,
                               std::uint32_t address) const;
  /// Its bytes are counted by class and purpose.
  void set(const eprosima::fastdds::rtps::EntityId_t& endpoint, const Mark& mark);
  void forget(const eprosima::fastdds::rtps::EntityId_t& endpoint);
  /// Notes a packet of `sent` bytes, with the message or a piece of it, and returns how it goes.
  [[nodiscard]] Way mark(const std::uint8_t* message, std::size_t size, std::size_t sent);
  /// The same for a packet by a path that holds a value of the emergency stop alone; its code
  /// point.
  [[nodiscard]] int mark_stop(std::size_t sent, PathIndex path);
  /// Notes such a value of `bytes` in a packet that was marked.
  void note_rider(std::size_t bytes, PathIndex path);
  [[nodiscard]] LinkPackets packets() const;

 private:
  using Endpoint = eprosima::fastdds::rtps::EntityId_t;
  void note_unknown(std::uint64_t bytes, bool discovery);
  mutable std::mutex mutex_;
  std::map<Endpoint, Mark> marks_;
  std::set<std::uint32_t> muted_;
  LinkPackets packets_;
  bool has_second_ = false;
};

}  // namespace tocsin
