// SPDX-License-Identifier: Apache-2.0
// From a write to the packet on wlan0: a component of another process and one of the router's own
// container, against raw Fast DDS that writes best effort on the link itself. All send the same
// message in turn, in one run of the mission's processes over the emulated radio, standing still.
// usage: link_hop [SMALL [IMAGES]]
#include <fmt/format.h>

#include <chrono>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "crossing.hpp"
#include "foundation/program.hpp"
#include "foundation/temporary_folder.hpp"
#include "foundation/whole_number.hpp"
#include "hop_message.hpp"
#include "measure.hpp"
#include "packet_tap.hpp"
#include "raw_dds.hpp"
#include "rtps_view.hpp"

namespace {

using namespace tocsin;
using bench::HopMessage;
using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr int raw_domain = 60;
constexpr const char* vehicle = "10.77.0.1";
constexpr const char* station = "10.77.0.2";

/// What is sent: the sum of the message's bytes, how often, and how many.
struct Load {
  const char* topic;  ///< of crossing_traffic's
  std::size_t octets;
  milliseconds period;
  int count;
};

/// One message each period, `offset` after its begin.
void repeat(const Load& load, milliseconds offset, const std::function<void()>& write) {
  auto next = std::chrono::steady_clock::now() + offset;
  for (;;) {
    std::this_thread::sleep_until(next);
    write();
    next += load.period;
  }
}

void write_raw(const Load& load) {
  bench::RawParticipant participant(raw_domain, bench::RawLink{vehicle, station});
  auto* const writer = participant.writer(load.topic);
  repeat(load, load.period / 2, [&] {
    HopMessage message = bench::hop_message(load.octets, "raw");
    (void)writer->write(&message);
  });
}

void read_raw(const Load& load) {
  bench::RawParticipant participant(raw_domain, bench::RawLink{station, vehicle});
  bench::RawListener listener(participant, [](void*) {});
  (void)participant.reader(load.topic, &listener);
  for (;;) pause();
}

void write_routed(Bus& bus, const Load& load) {
  const auto writer =
      bus.advertise({{load.topic, "stream", Scope::host}, &type_info<HopMessage>()});
  repeat(load, milliseconds(0), [&] {
    (void)writer->write(std::make_shared<HopMessage>(bench::hop_message(load.octets, "via")));
  });
}

/// From write to the first and to the last packet [ns].
struct Times {
  bench::Series first;
  bench::Series last;
};

/// What the captured packets of a run tell, by sender.
class Account {
 public:
  void add(const TappedPacket& packet) {
    const auto rtps = rtps_in(packet.bytes);
    if (!rtps || !packet.outgoing) return;
    for (const SamplePart& part : samples_in(*rtps)) {
      add({rtps->destination_port, {part.writer, part.number}}, part, packet.time_ns);
    }
  }
  [[nodiscard]] Times& of(const std::string& sender) { return times_[sender]; }

 private:
  struct Open {
    Times* times;
    std::int64_t written_ns;
  };
  using Key = std::pair<std::uint16_t, std::pair<std::uint32_t, std::int64_t>>;
  void add(const Key& key, const SamplePart& part, std::int64_t time_ns) {
    if (part.first) open(key, part, time_ns);
    const auto found = open_.find(key);
    if (found == open_.end() || !part.last) return;
    found->second.times->last.add(time_ns - found->second.written_ns);
    open_.erase(found);
  }
  void open(const Key& key, const SamplePart& part, std::int64_t time_ns) {
    // Encapsulation, seconds, nanoseconds, and the sender's name of three letters with its zero.
    constexpr std::size_t head = 4 + 4 + 4 + 4 + 4;
    if (part.bytes < head) return;
    std::int32_t sec = 0;
    std::uint32_t nanosec = 0;
    std::memcpy(&sec, part.payload + 4, sizeof sec);
    std::memcpy(&nanosec, part.payload + 8, sizeof nanosec);
    const std::string sender(reinterpret_cast<const char*>(part.payload) + 16, 3);
    if (sender != "raw" && sender != "via" && sender != "own") return;
    const std::int64_t written = sec * std::int64_t{1'000'000'000} + nanosec;
    times_[sender].first.add(time_ns - written);
    open_[key] = {&times_[sender], written};
  }
  std::map<Key, Open> open_;
  std::map<std::string, Times> times_;
};

void print(const std::string& what, const bench::Series& raw, const bench::Series& other) {
  fmt::print("{:<42}", what);
  for (const double share : {0.1, 0.5, 0.99}) {
    const double direct_us = 1e-3 * raw.percentile(share);
    const double routed_us = 1e-3 * other.percentile(share);
    fmt::print("  {:6.0f} {:6.0f} {:6.0f}", direct_us, routed_us, routed_us - direct_us);
  }
  fmt::print("\n");
}

/// The vehicle's link container with one more component.
std::string with_own_writer(const Load& load) {
  return fmt::format(
      "  uxv:\n"
      "    containers:\n"
      "      - name: link\n"
      "        components:\n"
      "          - {{component: hop_writer, parameters: {{octets: {}, period_s: {}}}}}\n",
      load.octets, 1e-3 * static_cast<double>(load.period.count()));
}

void measure(const Load& load) {
  const TemporaryFolder folder;
  const Stack stack({standing_mission(folder.path(), with_own_writer(load)), "--seed", "1",
                     "--without", "uxv/payload"});
  const auto runs = [&] { return stack.pid("gcs/recorder") != 0 && stack.pid("uxv/drive") != 0; };
  if (!Stack::eventually(seconds(30), runs)) throw std::runtime_error(stack.output());
  BusOptions on_host;
  on_host.name = "hop";
  on_host.host_domain = standing_domain;
  const pid_t here = stack.pid("uxv/drive");
  const PacketTap tap(here);
  if (!tap.ok()) throw std::runtime_error("the vehicle's namespace cannot be entered");
  const Peer reader(stack.pid("gcs/recorder"), [&load] { read_raw(load); });
  const Peer raw(here, [&load] { write_raw(load); });
  const Peer routed(here, on_host, [&load](Bus& bus) { write_routed(bus, load); });
  std::this_thread::sleep_for(load.period * load.count + seconds(4));
  Account account;
  const auto packets = tap.packets();
  for (const TappedPacket& packet : packets) account.add(packet);
  for (const auto& [sender, name] : {std::pair{"via", "other process"}, {"own", "own container"}}) {
    const std::string what = fmt::format("{} octets, {}, ", load.octets, name);
    print(what + "first packet", account.of("raw").first, account.of(sender).first);
    print(what + "last packet", account.of("raw").last, account.of(sender).last);
  }
}

void measure(int small, int images) {
  fmt::print("from write to packet [us]: raw, routed, more; 10th percentile, median, p99\n");
  measure({"crossing/up", 56, milliseconds(20), small});
  measure({"crossing/image", 30'000, milliseconds(150), images});
}

}  // namespace

int main(int argc, char** argv) {
  return tocsin::run_program("link_hop", [&] {
    measure(argc > 1 ? static_cast<int>(whole_number(argv[1], "SMALL", 1, 1'000'000)) : 2000,
            argc > 2 ? static_cast<int>(whole_number(argv[2], "IMAGES", 1, 1'000'000)) : 400);
    return 0;
  });
}
