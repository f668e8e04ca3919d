// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "devices/devices.hpp"

namespace tocsin {

/// A computer without devices. Its echo requests are refused with ENETUNREACH.
class AbsentDevices : public Devices {
 public:
  [[nodiscard]] OpenedSerial open_serial(const std::string& path, Readable readable) override;
  [[nodiscard]] std::unique_ptr<EchoDevice> open_echo(const EchoTarget& target,
                                                      Readable readable) override;
  [[nodiscard]] std::unique_ptr<network::WirelessDevice> open_wireless(
      const std::string& interface, const std::string& file) override;
  [[nodiscard]] std::unique_ptr<GamepadDevice> open_gamepad(const std::string& path) override;
  [[nodiscard]] std::unique_ptr<TerminalDevice> open_terminal() override { return nullptr; }
  [[nodiscard]] std::optional<std::string> read_text(const std::string& path) override;
  [[nodiscard]] std::vector<std::string> list_folder(const std::string& path) override;
  /// Without a thread.
  [[nodiscard]] std::unique_ptr<Background> open_background() override;
  [[nodiscard]] bool keeps_files() const override { return false; }
  [[nodiscard]] bool has_spectators() const override { return false; }
};

}  // namespace tocsin
