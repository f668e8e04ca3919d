// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include "background_thread.hpp"
#include "devices/devices.hpp"
#include "evdev_gamepad.hpp"
#include "icmp_socket.hpp"
#include "serial_port.hpp"
#include "standard_terminal.hpp"
#include "wireless_reader.hpp"

namespace tocsin {
namespace {

class RealDevices final : public Devices {
 public:
  OpenedSerial open_serial(const std::string& path, Readable /*readable*/) override {
    return open_serial_port(path);
  }
  std::unique_ptr<EchoDevice> open_echo(const EchoTarget& target, Readable /*readable*/) override {
    return std::make_unique<network::IcmpSocket>(target);
  }
  std::unique_ptr<network::WirelessDevice> open_wireless(const std::string& interface,
                                                         const std::string& file) override {
    return std::make_unique<network::WirelessReader>(interface, file);
  }
  std::unique_ptr<GamepadDevice> open_gamepad(const std::string& path) override {
    return open_evdev_gamepad(path);
  }
  std::unique_ptr<TerminalDevice> open_terminal() override { return open_standard_terminal(); }

  std::optional<std::string> read_text(const std::string& path) override {
    const std::ifstream file(path);
    std::ostringstream text;
    // A folder opens, and a sensor that fails gives an error when it is read: `<<` takes that.
    text << file.rdbuf();
    if (!text || text.str().empty()) return std::nullopt;
    return text.str();
  }

  std::vector<std::string> list_folder(const std::string& path) override {
    std::vector<std::string> names;
    std::error_code error;
    for (std::filesystem::directory_iterator it(path, error), end; !error && it != end;
         it.increment(error)) {
      names.push_back(it->path().filename());
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  std::unique_ptr<Background> open_background() override {
    return std::make_unique<BackgroundThread>();
  }
  [[nodiscard]] bool keeps_files() const override { return true; }
  [[nodiscard]] bool has_spectators() const override { return true; }
};

}  // namespace

Devices& real_devices() {
  static RealDevices devices;
  return devices;
}

}  // namespace tocsin
