// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "devices/background.hpp"
#include "devices/echo_device.hpp"
#include "devices/gamepad_device.hpp"
#include "devices/serial_device.hpp"
#include "devices/terminal_device.hpp"
#include "devices/wireless.hpp"

namespace tocsin {

/// What a component has of its computer besides topics. There is one for each kind of computer:
/// real_devices() is this one, `tocsin sim` has simulated ones, AbsentDevices have nothing, and a
/// component's test derives its own from those. A component cannot tell which it has.
///
/// One thread at a time. `readable` is called when something came to a device without a descriptor
/// (see Device), on the thread of its component, until the device is destroyed.
class Devices {
 public:
  using Readable = std::function<void()>;
  virtual ~Devices() = default;
  /// The serial port of a path, for ourselves alone. What was waiting in it is discarded.
  [[nodiscard]] virtual OpenedSerial open_serial(const std::string& path, Readable readable) = 0;
  /// Never null. Throws ConfigError when the target is no IPv4 address, EnvironmentError when this
  /// process may not send echo requests.
  [[nodiscard]] virtual std::unique_ptr<EchoDevice> open_echo(const EchoTarget& target,
                                                              Readable readable) = 0;
  /// Never null. What the kernel cannot tell of the interface is read from `file`, in the format
  /// of /proc/net/wireless.
  [[nodiscard]] virtual std::unique_ptr<network::WirelessDevice> open_wireless(
      const std::string& interface, const std::string& file) = 0;
  /// The gamepad of a path, or with an empty one the first there is. Null: none.
  [[nodiscard]] virtual std::unique_ptr<GamepadDevice> open_gamepad(const std::string& path) = 0;
  /// The terminal of this process: keys without echo and without waiting for Enter, as before again
  /// when it is destroyed; without a terminal standard input as it is. Null: nobody can type.
  [[nodiscard]] virtual std::unique_ptr<TerminalDevice> open_terminal() = 0;
  /// The text of a device file, as in /proc; empty when there is none or it is empty.
  [[nodiscard]] virtual std::optional<std::string> read_text(const std::string& path) = 0;
  /// The names in a folder of device files, as in /sys/class, sorted; none when it is not there.
  [[nodiscard]] virtual std::vector<std::string> list_folder(const std::string& path) = 0;
  /// Never null.
  [[nodiscard]] virtual std::unique_ptr<Background> open_background() = 0;
  /// Whether components keep files for the process that takes over after them, in the folder of
  /// the run; only useful when processes can crash.
  [[nodiscard]] virtual bool keeps_files() const = 0;
  /// Whether somebody can look at pictures; where nobody can, only their sizes matter.
  [[nodiscard]] virtual bool has_spectators() const = 0;
};

/// The devices of this computer. Any thread.
[[nodiscard]] Devices& real_devices();

}  // namespace tocsin
