// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace tocsin::interop {

/// A participant with a reliable reader and a reliable writer of the topic rt/interop, type
/// std_msgs/String. Nothing of it is configured beyond that: it is as its library makes it.
class Peer {
 public:
  virtual ~Peer() = default;
  virtual void write(const std::string& text) = 0;
  /// What came since the last call.
  virtual std::vector<std::string> take() = 0;
};

inline constexpr const char* topic_name = "interop";
inline constexpr const char* topic_on_wire = "rt/interop";
inline constexpr const char* type_on_wire = "std_msgs::msg::dds_::String_";

[[nodiscard]] std::unique_ptr<Peer> make_cyclone_peer(int domain);
[[nodiscard]] std::unique_ptr<Peer> make_fast_dds_peer(int domain);
/// A process of ours, by the runtime's bus.
[[nodiscard]] std::unique_ptr<Peer> make_tocsin_peer(int domain);

}  // namespace tocsin::interop
