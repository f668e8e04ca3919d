// SPDX-License-Identifier: Apache-2.0
// The whole component in a network namespace of its own whose wireless interface is deleted.
#include <gtest/gtest.h>
#include <net/if.h>
#include <poll.h>
#include <sched.h>
#include <stdlib.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "foundation/temporary_folder.hpp"
#include "network_monitor/network_monitor_component.hpp"
#include "runtime/sim_bus.hpp"

namespace tocsin {
namespace {

bool run(const char* command) { return ::system(command) == 0; }

/// An interface wlan0 with an address, in a new namespace that this process enters.
bool make_interface() {
  const bool entered = ::unshare(CLONE_NEWNET) == 0 ||
                       (::geteuid() != 0 && ::unshare(CLONE_NEWUSER | CLONE_NEWNET) == 0);
  return entered && run("ip link set lo up") && run("ip tuntap add dev wlan0 mode tun") &&
         run("ip address add 10.77.0.1/24 dev wlan0") && run("ip link set wlan0 up");
}

/// Like what link_emulator or a driver tells of a good link.
void write_wireless(const std::string& path) {
  std::ofstream(path)
      << "Inter-| sta-|   Quality        |   Discarded packets\n"
         " face | tus | link level noise |  nwid  crypt   frag  retry\n"
         " wlan0: 0000   60.  -50.  -256        0      0      0      0      0        0\n";
}

using Quality = topic::NetworkQuality::Message;

/// Ticks on the real clock, as the runner would, until a sample is as wanted.
template <class Wanted>
bool run_until(NetworkMonitorComponent& sut, SimReader<topic::NetworkQuality>& samples,
               const Wanted& wanted) {
  const Time end = std::chrono::steady_clock::now() + seconds(20);
  for (Time now{}; now < end;) {
    now = std::chrono::steady_clock::now();
    sut.schedule().begin_tick(now);
    sut.tick(now);
    for (const Quality& sample : samples.take()) {
      if (wanted(sample)) return true;
    }
    const auto wait = std::chrono::ceil<std::chrono::milliseconds>(sut.schedule().due() - now);
    pollfd descriptor{sut.schedule().descriptors.at(0), POLLIN, 0};
    (void)poll(&descriptor, 1, static_cast<int>(std::max<std::int64_t>(0, wait.count())));
  }
  return false;
}

TEST(DeletedInterface, IsADeadLinkWithoutSignal) {
  if (!make_interface()) GTEST_SKIP() << "no network namespace or no TUN here";
  const TemporaryFolder folder;
  SimBus bus;
  Context context{bus, "network_monitor", Role::uxv};
  SimReader<topic::NetworkQuality> samples(bus);
  NetworkMonitorComponent::Params params;
  params.target = "10.77.0.1";
  params.wireless_file = folder.path("wireless");
  params.probe = {0.02, 0.1, 10, 0.1};
  write_wireless(params.wireless_file);
  NetworkMonitorComponent sut(context, params);
  EXPECT_TRUE(run_until(sut, samples, [](const Quality& sample) {
    return sample.per_percent() == 0 && sample.signal_dbm() == -50 &&
           sample.wireless_source() == "proc";
  }));
  ASSERT_TRUE(run("ip link delete wlan0"));
  write_wireless(params.wireless_file);  // whoever writes it has not noticed
  EXPECT_TRUE(run_until(sut, samples, [](const Quality& sample) {
    return sample.per_percent() == 100 && sample.wireless_source() == "absent" &&
           std::isnan(sample.signal_dbm()) && std::isnan(sample.quality_percent());
  }));
}

}  // namespace
}  // namespace tocsin
