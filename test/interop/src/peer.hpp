// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace tocsin::interop {

/// What a peer has heard.
struct HeardText {
  std::string text;
  long long at_ms = 0;  ///< when it was given to the program, see now_ms
};

/// A participant with a reliable reader and a reliable writer of the topic rt/interop, type
/// std_msgs/String. Nothing of it is configured beyond that and the lifespan of its samples: it is
/// as its library makes it.
class Peer {
 public:
  virtual ~Peer() = default;
  virtual void write(const std::string& text) = 0;
  /// What came since the last call.
  virtual std::vector<HeardText> take() = 0;
};

/// [ms] by the clock that all processes of a computer share.
[[nodiscard]] long long now_ms();

struct PeerSettings {
  int domain = 0;
  int lifespan_ms = 0;  ///< of what it writes; 0: for ever
};

inline constexpr const char* topic_name = "interop";
inline constexpr const char* topic_on_wire = "rt/interop";
inline constexpr const char* type_on_wire = "std_msgs::msg::dds_::String_";

[[nodiscard]] std::unique_ptr<Peer> make_cyclone_peer(const PeerSettings& settings);
[[nodiscard]] std::unique_ptr<Peer> make_fast_dds_peer(const PeerSettings& settings);
/// A process of ours, by the runtime's bus.
[[nodiscard]] std::unique_ptr<Peer> make_tocsin_peer(const PeerSettings& settings);

}  // namespace tocsin::interop
