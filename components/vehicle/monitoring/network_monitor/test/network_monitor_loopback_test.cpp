// SPDX-License-Identifier: Apache-2.0
// The whole component with real ICMP on the machine's loopback.
#include <gtest/gtest.h>
#include <poll.h>

#include "foundation/error.hpp"
#include "network_monitor/network_monitor_component.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

bool may_send_echo() {
  try {
    (void)this_computer().devices.open<EchoDevice>({"127.0.0.1", 8});
    return true;
  } catch (const EnvironmentError&) {
    return false;
  }
}

/// Ticks on the real clock, as the runner would.
void run(NetworkMonitorComponent& sut, Time end) {
  Time now = std::chrono::steady_clock::now();
  for (; now < end; now = std::chrono::steady_clock::now()) {
    sut.schedule().begin_tick(now);
    sut.tick(now);
    const auto wait = std::chrono::ceil<std::chrono::milliseconds>(sut.schedule().due() - now);
    pollfd descriptor{sut.schedule().descriptors.at(0), POLLIN, 0};
    (void)poll(&descriptor, 1, static_cast<int>(wait.count()));
  }
}

TEST(NetworkMonitor, MeasuresLoopbackWithoutLoss) {
  if (!may_send_echo()) GTEST_SKIP() << "neither kind of ICMP socket is allowed here";
  SimBus bus;
  Context context{bus, "network_monitor", Role::uxv};
  SimReader<topic::NetworkQuality> samples(bus);
  NetworkMonitorComponent::Params params;
  params.target = "127.0.0.1";
  params.interface_name = "lo";
  params.probe.period_s = 0.05;
  params.probe.sample_period_s = 0.5;
  NetworkMonitorComponent sut(context, params);
  run(sut, std::chrono::steady_clock::now() + seconds(2.6));
  const auto taken = samples.take();
  ASSERT_GE(taken.size(), 2U);
  EXPECT_EQ(taken.back().per_percent(), 0.0F);
  EXPECT_GE(taken.back().probes_received(), 5U);
  EXPECT_LT(taken.back().rtt_min_ms(), 50.0F);
  EXPECT_EQ(taken.back().wireless_source(), "absent");
}

}  // namespace
}  // namespace tocsin
