// SPDX-License-Identifier: Apache-2.0
#include "stop_troubles.hpp"

#include <signal.h>

#include <chrono>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "runtime/testing/forger.hpp"
#include "storm.hpp"

namespace tocsin {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

/// As a peer at the station, on the link too.
BusOptions on_link() {
  BusOptions options = on_host(site_domain + 1);
  options.link_domain = site_domain + 2;
  options.link_address = station_address;
  options.link_peers = {vehicle_address};
  return options;
}

std::shared_ptr<void> nothing(const StopSite&) { return nullptr; }

/// Of a router that may be about to be started again.
pid_t running(const StopSite& site, const std::string& router) {
  pid_t pid = 0;
  const bool runs =
      Stack::eventually(seconds(60), [&] { return (pid = site.stack().pid(router)) > 0; });
  if (!runs) throw std::runtime_error(router + " does not run");
  return pid;
}

Trouble frozen(const std::string& router, int time_s) {
  return [=](const StopSite& site) -> std::shared_ptr<void> {
    const pid_t pid = running(site, router);
    ::kill(pid, SIGSTOP);
    std::this_thread::sleep_for(seconds(time_s));
    ::kill(pid, SIGCONT);
    return nullptr;
  };
}

/// How often the router of a host has met the other one.
std::ptrdiff_t meetings(const StopSite& site, const std::string& host) {
  std::istringstream log(site.stack().read("log/" + host + ".link.log"));
  std::ptrdiff_t count = 0;
  for (std::string line; std::getline(log, line);) {
    count += line.find("is on the link") == std::string::npos ? 0 : 1;
  }
  return count;
}

/// Killed with -9, and back when it has met the other one again.
Trouble killed(const std::string& host) {
  return [=](const StopSite& site) -> std::shared_ptr<void> {
    const auto before = meetings(site, host);
    ::kill(running(site, host + "/link"), SIGKILL);
    if (!Stack::eventually(seconds(60), [&] { return meetings(site, host) > before; })) {
      throw std::runtime_error("the router of " + host + " is not back");
    }
    return nullptr;
  };
}

using Forge = std::function<void(const Forger& forger, const Forger::Overheard& victim, int turn)>;

/// Somebody on each host's network speaks to the other in its router's name, fifty times a second.
std::shared_ptr<void> forging(const StopSite& site, const Forge& forge) {
  struct Forgers {
    std::vector<std::unique_ptr<Peer>> all;
  };
  auto forgers = std::make_shared<Forgers>();
  for (const std::string host : {"uxv", "gcs"}) {
    const bool up = host == "uxv";
    const Forger::Way way{up ? vehicle_address : station_address,
                          up ? station_address : vehicle_address};
    forgers->all.push_back(std::make_unique<Peer>(site.stack().running(host + "/recorder"), [=] {
      const Forger forger(site_domain + 2, way);
      const auto victim = forger.overhear(host);
      if (!victim) throw std::runtime_error("nothing is overheard of " + host);
      for (int turn = 0;; ++turn) {
        forge(forger, *victim, turn);
        std::this_thread::sleep_for(milliseconds(20));
      }
    }));
  }
  std::this_thread::sleep_for(milliseconds(1500));
  return forgers;
}

void departs(const Forger& forger, const Forger::Overheard& victim, int) {
  forger.send(Forger::departure_of(victim), victim.port);
}

void leases(const Forger& forger, const Forger::Overheard& victim, int turn) {
  forger.send(Forger::with_lease(victim, turn % 2 == 0 ? 0 : 0x7fffffff), victim.port);
}

void names(const Forger& forger, const Forger::Overheard& victim, int turn) {
  const auto number = static_cast<std::uint32_t>(turn % 128 + 1);
  forger.send(Forger::stranger_like(victim, number), forger.port());
}

void exaggerates(const Forger& forger, const Forger::Overheard&, int turn) {
  for (const Forger::Overheard& heard : forger.overhear_all()) {
    forger.send(Forger::exaggerated(heard.announcement, turn % 2 == 0 ? 5 : 1U << 20U), heard.port);
  }
}

Trouble with(Forge forge) {
  return [=](const StopSite& site) { return forging(site, forge); };
}

/// A stranger on the link publishes velocities for the vehicle.
std::shared_ptr<void> stranger(const StopSite& site) {
  auto peer =
      std::make_shared<Peer>(site.stack().running("gcs/recorder"), on_link(), turn_on_the_spot());
  std::this_thread::sleep_for(milliseconds(1500));
  return peer;
}

/// Odd packets for all sockets of both hosts, as many as they take.
std::shared_ptr<void> flood(const StopSite& site) {
  auto peers = std::make_shared<std::vector<std::unique_ptr<Peer>>>();
  for (const char* process : {"uxv/recorder", "gcs/recorder"}) {
    peers->push_back(std::make_unique<Peer>(site.stack().running(process), [] {
      const fuzz::Attacker attacker;
      for (unsigned seed = 1;; ++seed) {
        fuzz::send_storm(attacker, {5000, 5000, 2000, seed});
      }
    }));
  }
  std::this_thread::sleep_for(milliseconds(500));
  return peers;
}

std::shared_ptr<void> full_disk(const StopSite& site) {
  site.stack().fill_disk("fill");
  return nullptr;
}

}  // namespace

std::vector<Condition> conditions() {
  return {{"nothing", nothing},
          {"station's router frozen 1 s", frozen("gcs/link", 1)},
          {"station's router frozen 5 s", frozen("gcs/link", 5)},
          {"station's router frozen 30 s", frozen("gcs/link", 30)},
          {"vehicle's router frozen 1 s", frozen("uxv/link", 1)},
          {"vehicle's router frozen 5 s", frozen("uxv/link", 5)},
          {"vehicle's router frozen 30 s", frozen("uxv/link", 30)},
          {"station's router killed", killed("gcs")},
          {"vehicle's router killed", killed("uxv")},
          {"forged departures", with(departs), true},
          {"forged leases", with(leases), true},
          {"forged names", with(names), true},
          {"forged origins and acknowledgements", with(exaggerates), true},
          {"stranger's cmd_vel on the link", stranger, true},
          {"flood of odd packets", flood, true},
          {"full disk", full_disk, true, 24}};
}

}  // namespace tocsin
