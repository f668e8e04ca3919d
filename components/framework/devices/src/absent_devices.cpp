// SPDX-License-Identifier: Apache-2.0
#include "devices/absent_devices.hpp"

#include <cerrno>

namespace tocsin {
namespace {

class NoEcho final : public EchoDevice {
  SendResult send(std::uint16_t /*sequence*/) override { return {{}, ENETUNREACH}; }
  std::optional<EchoReply> receive() override { return std::nullopt; }
};

class NoWireless final : public network::WirelessDevice {
  network::WirelessReading read() override {
    return network::absent("this computer has no wireless interface");
  }
};

class AtOnce final : public Background {
  void post(std::function<void()> work) override { work(); }
  [[nodiscard]] std::size_t waiting() const override { return 0; }
};

}  // namespace

OpenedSerial AbsentDevices::open_serial(const std::string& path, Readable /*readable*/) {
  return {OpenedSerial::Result::absent, nullptr, path + ": no such device", false};
}

std::unique_ptr<EchoDevice> AbsentDevices::open_echo(const EchoTarget& /*target*/,
                                                     Readable /*readable*/) {
  return std::make_unique<NoEcho>();
}

std::unique_ptr<network::WirelessDevice> AbsentDevices::open_wireless(
    const std::string& /*interface*/, const std::string& /*file*/) {
  return std::make_unique<NoWireless>();
}

std::unique_ptr<GamepadDevice> AbsentDevices::open_gamepad(const std::string& /*path*/) {
  return nullptr;
}

std::optional<std::string> AbsentDevices::read_text(const std::string& /*path*/) {
  return std::nullopt;
}

std::vector<std::string> AbsentDevices::list_folder(const std::string& /*path*/) { return {}; }

std::unique_ptr<Background> AbsentDevices::open_background() { return std::make_unique<AtOnce>(); }

}  // namespace tocsin
