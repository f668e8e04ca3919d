// SPDX-License-Identifier: Apache-2.0
#include "simulated_port.hpp"

#include <utility>

namespace tocsin::kobuki {
namespace {

class SimulatedPort final : public BytePort {
 public:
  explicit SimulatedPort(std::unique_ptr<SerialDevice> device) : device_(std::move(device)) {}
  int descriptor() const override { return -1; }
  std::optional<std::size_t> read(std::uint8_t* to, std::size_t size) override {
    return device_->read(to, size);
  }
  bool write(ByteView bytes) override { return device_->write(bytes.data, bytes.size); }

 private:
  std::unique_ptr<SerialDevice> device_;
};

}  // namespace

Opened open_simulated_port(Devices& devices, const std::string& path, Devices::Readable readable) {
  auto device = devices.open_serial(path, std::move(readable));
  if (!device) return {Opened::Result::absent, nullptr, path + ": no such device", false};
  return {Opened::Result::open, std::make_unique<SimulatedPort>(std::move(device)), {}, false};
}

}  // namespace tocsin::kobuki
