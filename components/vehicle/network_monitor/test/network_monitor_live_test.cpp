// SPDX-License-Identifier: Apache-2.0
// What may be set while the network is monitored.
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include "devices/computer.hpp"
#include "foundation/error.hpp"
#include "network_monitor/network_monitor_component.hpp"
#include "runtime/component_entry.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

TEST(NetworkMonitorLive, TakesAnotherWindowWhileItRunsAndKeepsItOnARefusal) {
  SimBus bus;
  Computer computer;
  computer.devices = Devices(Devices::Unknown::silent);
  Context context = Context(bus, "network_monitor", Role::uxv).with_computer(computer);
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
