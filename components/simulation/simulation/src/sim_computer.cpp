// SPDX-License-Identifier: Apache-2.0
#include "sim_computer.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <deque>
#include <utility>

#include "devices/device_files.hpp"
#include "foundation/error.hpp"

namespace tocsin::simulation {
namespace {

constexpr std::size_t ip_and_icmp_bytes = 28;

/// Requests and replies are packets of the link. The host at the other side answers at once.
class SimEcho final : public EchoDevice {
 public:
  struct Probe {
    const std::string* host;
    RadioLink* link;
    Way way;
    std::size_t bytes;
    bool answered;
  };
  SimEcho(Core& core, const Probe& probe, Devices::Readable readable)
      : core_(core), probe_(probe), inbox_(std::make_shared<Inbox>()) {
    inbox_->readable = std::move(readable);
  }
  ~SimEcho() override {
    inbox_->readable = [] {};
  }

  SendResult send(std::uint16_t sequence) override {
    const Request request{sequence, core_.now};
    if (Observer* const observer = core_.observer(probe_.way.vehicle)) {
      observer->on_echo({*probe_.host, sequence, core_.now, never});
    }
    probe_.link->send(probe_.way, probe_.bytes,
                      [&core = core_, probe = probe_, inbox = inbox_, request] {
                        if (probe.answered) answer(core, probe, inbox, request);
                      });
    return {core_.now, 0};
  }
  std::optional<EchoReply> receive() override {
    if (inbox_->replies.empty()) return std::nullopt;
    const EchoReply reply = inbox_->replies.front();
    inbox_->replies.pop_front();
    return reply;
  }

 private:
  /// Outlives the component as long as packets are under way.
  struct Inbox {
    std::deque<EchoReply> replies;
    Devices::Readable readable;
  };
  struct Request {
    std::uint16_t sequence;
    Time sent;
  };
  static void answer(Core& core, const Probe& probe, const std::shared_ptr<Inbox>& inbox,
                     const Request& request) {
    probe.link->send(back(probe.way), probe.bytes, [&core, probe, inbox, request] {
      Observer* const observer = core.observer(probe.way.vehicle);
      if (observer != nullptr) {
        observer->on_echo({*probe.host, request.sequence, request.sent, core.now});
      }
      inbox->replies.push_back({request.sequence, core.now});
      inbox->readable();
    });
  }
  Core& core_;
  Probe probe_;
  std::shared_ptr<Inbox> inbox_;
};

/// What a file of the simulated computer tells of an interface.
class SimWireless final : public network::WirelessDevice {
 public:
  SimWireless(const SimComputer& computer, network::WirelessAddress at)
      : computer_(computer), at_(std::move(at)) {}
  network::WirelessReading read() override {
    const auto text = computer_.read_file(at_.file);
    return text ? network::parse_proc_wireless(*text, at_.interface)
                : network::absent(at_.file + " cannot be read");
  }

 private:
  const SimComputer& computer_;
  network::WirelessAddress at_;
};

class SimTruePose final : public TruePose {
 public:
  explicit SimTruePose(const SimBase& base) : base_(base) {}
  geometry::Pose read() override { return base_.true_pose(); }

 private:
  const SimBase& base_;
};

class SimFiles final : public DeviceFiles {
 public:
  explicit SimFiles(const SimComputer& computer) : computer_(computer) {}
  std::optional<std::string> read(const std::string& path) override {
    return computer_.read_file(path);
  }

 private:
  const SimComputer& computer_;
};

}  // namespace

SimComputer::SimComputer(Core& core, RadioLink& link, const Place& place, std::string wireless_file)
    : core_(core), link_(link), place_(place), wireless_file_(std::move(wireless_file)) {
  using Readable = Devices::Readable;
  devices.add<SerialDevice>([this](const std::string& path, Readable readable) {
    return open_serial(path, std::move(readable));
  });
  devices.add<EchoDevice>([this](const EchoTarget& target, Readable readable) {
    return open_echo(target, std::move(readable));
  });
  devices.add<network::WirelessDevice>([this](const network::WirelessAddress& at, const Readable&) {
    return std::make_unique<SimWireless>(*this, at);
  });
  devices.add<TruePose>([this](const std::string&, const Readable&) -> Opened<TruePose> {
    if (bases_.empty()) return {};
    return std::make_unique<SimTruePose>(*bases_.front());
  });
  devices.add<DeviceFiles>(
      [this](const std::string&, const Readable&) { return std::make_unique<SimFiles>(*this); });
}

OpenedSerial SimComputer::open_serial(const std::string& path, Devices::Readable readable) {
  for (SimBase* const base : bases_) {
    if (base->path() == path) return base->open(std::move(readable));
    SimLaser* const laser = base->laser();
    if (laser != nullptr && laser->path() == path) return laser->open(std::move(readable));
  }
  return {};
}

std::unique_ptr<EchoDevice> SimComputer::open_echo(const EchoTarget& target,
                                                   Devices::Readable readable) {
  in_addr address{};
  if (inet_pton(AF_INET, target.address.c_str(), &address) != 1) {
    throw ConfigError("target: '" + target.address + "' is not an IPv4 address");
  }
  const bool answered = std::find(peers_.begin(), peers_.end(), target.address) != peers_.end();
  const SimEcho::Probe probe{&place_.host, &link_,
                             Way(place_.direction, target.dscp, place_.vehicle),
                             ip_and_icmp_bytes + target.payload_bytes, answered};
  return std::make_unique<SimEcho>(core_, probe, std::move(readable));
}

std::optional<std::string> SimComputer::read_file(const std::string& path) const {
  if (path == wireless_file_ || path == "/proc/net/wireless")
    return link_.wireless_text(place_.vehicle);
  if (path == "/proc/meminfo") return "MemTotal: 1000000 kB\nMemAvailable: 600000 kB\n";
  if (path == "/proc/stat") return stat_text();
  return std::nullopt;
}

std::string SimComputer::stat_text() const {
  const auto ticks = (core_.now - start_time) / std::chrono::milliseconds(10);
  const std::string busy = std::to_string(1000 + ticks / 4);
  const std::string idle = std::to_string(3000 + ticks - ticks / 4);
  const std::string times = " " + busy + " 0 0 " + idle + " 0 0 0 0\n";
  return "cpu " + times + "cpu0" + times;
}

}  // namespace tocsin::simulation
