// SPDX-License-Identifier: Apache-2.0
// What may be set while the network is monitored.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "devices/absent_devices.hpp"
#include "foundation/error.hpp"
#include "network_monitor/network_monitor_component.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

/// Nobody answers.
class SilentEcho final : public EchoDevice {
 public:
  explicit SilentEcho(const SimBus& bus) : bus_(bus) {}
  SendResult send(std::uint16_t) override { return {bus_.now(), 0}; }
  std::optional<EchoReply> receive() override { return std::nullopt; }

 private:
  const SimBus& bus_;
};

class SilentDevices final : public AbsentDevices {
 public:
  explicit SilentDevices(const SimBus& bus) : bus_(bus) {}
  std::unique_ptr<EchoDevice> open_echo(const EchoTarget&, Readable) override {
    return std::make_unique<SilentEcho>(bus_);
  }

 private:
  const SimBus& bus_;
};

TEST(NetworkMonitorLive, TakesAnotherWindowWhileItRunsAndKeepsItOnARefusal) {
  SimBus bus;
  SilentDevices devices(bus);
  Context context = Context(bus, "network_monitor", Role::uxv).with_devices(devices);
  const ComponentEntry entry = make_component_entry<NetworkMonitorComponent>();
  const auto sut = entry.create(context, YAML::Load("{interface_name: ''}"), {});
  SimReader<topic::NetworkQuality> samples(bus);
  bus.add(*sut);
  entry.change(*sut, YAML::Load("{interface_name: '', window: 3}"), {});
  bus.run_for(seconds(10));
  EXPECT_EQ(samples.take().back().probes_sent(), 3U);
  EXPECT_THROW(entry.change(*sut, YAML::Load("{interface_name: '', window: 0}"), {}), ConfigError);
  bus.run_for(seconds(10));
  EXPECT_EQ(samples.take().back().probes_sent(), 3U);
}

}  // namespace
}  // namespace tocsin
