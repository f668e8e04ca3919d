// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include "background_thread.hpp"
#include "devices/computer.hpp"
#include "devices/device_files.hpp"
#include "evdev_gamepad.hpp"
#include "icmp_socket.hpp"
#include "serial_port.hpp"
#include "standard_terminal.hpp"
#include "wireless_reader.hpp"

namespace tocsin {
namespace {

using network::WirelessDevice;

class Files final : public DeviceFiles {
 public:
  std::optional<std::string> read(const std::string& path) override {
    const std::ifstream file(path);
    std::ostringstream text;
    // A folder opens, and a sensor that fails gives an error when it is read: `<<` takes that.
    text << file.rdbuf();
    if (!text || text.str().empty()) return std::nullopt;
    return text.str();
  }

  std::vector<std::string> list(const std::string& folder) override {
    std::vector<std::string> names;
    std::error_code error;
    for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error)) {
      names.push_back(it->path().filename());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
};

Computer make_this_computer() {
  using Readable = Devices::Readable;
  Computer computer{Devices(), true, true, [] { return std::make_unique<BackgroundThread>(); }};
  Devices& devices = computer.devices;
  devices.add<SerialDevice>(
      [](const std::string& path, const Readable&) { return open_serial_port(path); });
  devices.add<EchoDevice>([](const EchoTarget& target, const Readable&) {
    return std::make_unique<network::IcmpSocket>(target);
  });
  devices.add<WirelessDevice>([](const WirelessDevice::Address& at, const Readable&) {
    return std::make_unique<network::WirelessReader>(at.interface, at.file);
  });
  devices.add<GamepadDevice>(
      [](const std::string& path, const Readable&) { return open_evdev_gamepad(path); });
  devices.add<TerminalDevice>(
      [](const std::string&, const Readable&) { return open_standard_terminal(); });
  devices.add<DeviceFiles>(
      [](const std::string&, const Readable&) { return std::make_unique<Files>(); });
  return computer;
}

}  // namespace

Computer& this_computer() {
  static Computer computer = make_this_computer();
  return computer;
}

}  // namespace tocsin
