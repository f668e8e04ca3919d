// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <variant>

#include "file_descriptor.hpp"
#include "radio_channel/channel_params.hpp"

namespace tocsin::link {

/// `pos X Y`, in metres in the map frame.
struct MoveTo {
  double x_m;
  double y_m;
};

/// `set outage SECONDS`: nothing is received from now on, (0, 86400] seconds.
struct BeginOutage {
  double length_s;
};

/// `set KEY VALUE` with a parameter of the channel file.
struct SetParameter {
  std::string key;
  std::string value;
};

/// What a datagram asks for; monostate when it is malformed.
using Command = std::variant<std::monostate, MoveTo, BeginOutage, SetParameter>;

[[nodiscard]] Command parse_command(const std::string& datagram);

/// Changes one parameter. False, and nothing changed, when the key is unknown or is a list, or the
/// value has the wrong type or lies outside its range.
[[nodiscard]] bool set_parameter(radio::ChannelParams& params, const SetParameter& command);

/// A unix datagram socket with a pathname, so that senders in any network namespace reach it.
class ControlSocket {
 public:
  /// Replaces a socket left over by a dead process. Throws ConfigError when the path cannot be
  /// bound.
  explicit ControlSocket(const std::string& path);
  ~ControlSocket();
  ControlSocket(const ControlSocket&) = delete;
  ControlSocket& operator=(const ControlSocket&) = delete;

  [[nodiscard]] int fd() const { return fd_.get(); }
  /// False when no datagram waits. Longer datagrams are cut at 256 bytes.
  [[nodiscard]] bool receive(std::string& datagram);

 private:
  std::string path_;
  FileDescriptor fd_;
};

}  // namespace tocsin::link
