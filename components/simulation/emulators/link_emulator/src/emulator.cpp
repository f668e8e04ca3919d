// SPDX-License-Identifier: Apache-2.0
#include "emulator.hpp"

#include <arpa/inet.h>
#include <sys/epoll.h>
#include <sys/signalfd.h>
#include <sys/timerfd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <utility>

#include "foundation/error.hpp"
#include "foundation/replace_file.hpp"
#include "geometry/wall_file.hpp"
#include "radio_channel/channel_files.hpp"

namespace tocsin::link {
namespace {

constexpr Duration tick_period{20'000'000};  // notices a frozen machine even when no packet flows
constexpr Duration report_period{1'000'000'000};
constexpr int packets_per_wake_up = 64;

Time clock_now() { return std::chrono::steady_clock::now(); }

FileDescriptor stop_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGTERM);
  sigaddset(&set, SIGINT);
  sigprocmask(SIG_BLOCK, &set, nullptr);
  return FileDescriptor(::signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC));
}

timespec timespec_of(Time t) {
  const auto ns = std::max<std::int64_t>(1, t.time_since_epoch().count());
  return {static_cast<time_t>(ns / 1'000'000'000), static_cast<long>(ns % 1'000'000'000)};
}

}  // namespace

radio::RadioChannel make_channel(const Options& options, Time start) {
  std::vector<geometry::Wall> walls;
  if (!options.walls_file.empty()) walls = geometry::load_walls(options.walls_file);
  return {radio::load_channel(options.channel_file), walls, options.seed, start,
          options.vehicles.size()};
}

Emulator::Vehicle::Vehicle(const Options& options, std::size_t index)
    : end(options.vehicles[index]),
      address(::inet_addr(end.address.c_str())),
      tun(end, options.interface),
      wireless_path(path_for(options.wireless_path, end)) {
  const std::string control_path = path_for(options.control_path, end);
  const std::string stats_path = path_for(options.stats_path, end);
  if (!control_path.empty()) control = std::make_unique<DatagramSocket>(control_path);
  if (!stats_path.empty()) stats = std::make_unique<StatsFile>(stats_path);
}

Emulator::Station::Station(const Options& options, std::size_t index)
    : end(options.stations[index]),
      address(::inet_addr(end.address.c_str())),
      tun(end, options.interface) {}

Emulator::Emulator(const Options& options)
    : options_(options),
      signals_(stop_signals()),
      epoll_(::epoll_create1(EPOLL_CLOEXEC)),
      timer_(::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)),
      start_(clock_now()),
      channel_(make_channel(options, start_)),
      tick_at_(start_ + tick_period),
      report_at_(start_ + report_period) {
  for (std::size_t i = 0; i < options.vehicles.size(); ++i) {
    Vehicle& vehicle = vehicles_.emplace_back(options, i);
    if (vehicle.control) watch(vehicle.control->descriptor());
    const std::string text = wireless_text(options.interface, channel_.report(start_, i));
    if (const auto error = write_wireless(vehicle, text)) {
      throw ConfigError("--wireless " + vehicle.wireless_path + ": " + error.message());
    }
    watch(vehicle.tun.fd());
  }
  for (std::size_t i = 0; i < options.stations.size(); ++i) {
    watch(stations_.emplace_back(options, i).tun.fd());
  }
  for (const int fd : {signals_.get(), timer_.get()}) watch(fd);
}

void Emulator::watch(int fd) {
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = fd;
  ::epoll_ctl(epoll_.get(), EPOLL_CTL_ADD, fd, &event);
}

void Emulator::run() {
  while (running_) {
    wait();
    deliver();
    if (clock_now() >= report_at_) report();
  }
  for (Vehicle& vehicle : vehicles_) vehicle.tun.remove_at_end();
  for (Station& station : stations_) station.tun.remove_at_end();
}

void Emulator::wait() {
  const Time due = std::min({channel_.next_event(), tick_at_, report_at_});
  const itimerspec wake_up{{0, 0}, timespec_of(due)};
  ::timerfd_settime(timer_.get(), TFD_TIMER_ABSTIME, &wake_up, nullptr);
  std::array<epoll_event, 8> events;
  const int count = ::epoll_wait(epoll_.get(), events.data(), events.size(), -1);
  const Time now = clock_now();
  if (now > due) counters_.late = std::max(counters_.late, now - due);
  if (now >= tick_at_) tick_at_ = now + tick_period;
  for (int i = 0; i < count; ++i) handle(events[static_cast<std::size_t>(i)].data.fd);
}

void Emulator::handle(int fd) {
  if (fd == signals_.get()) running_ = false;
  for (Station& station : stations_) {
    if (fd == station.tun.fd()) carry_from_station(station);
  }
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    Vehicle& vehicle = vehicles_[i];
    if (fd == vehicle.tun.fd()) carry_from(i);
    if (!vehicle.control || fd != vehicle.control->descriptor()) continue;
    while (const auto message = vehicle.control->receive()) obey(message->text, i);
  }
}

void Emulator::carry_from(std::size_t index) {
  Vehicle& vehicle = vehicles_[index];
  for (int i = 0; i < packets_per_wake_up; ++i) {
    Bytes packet = vehicle.tun.read();
    if (vehicle.tun.gone()) forget(vehicle.tun, vehicle.end);
    if (packet.empty()) return;
    push(radio::Direction::uplink, index, std::move(packet));
  }
}

void Emulator::carry_from_station(Station& station) {
  for (int i = 0; i < packets_per_wake_up; ++i) {
    const Bytes packet = station.tun.read();
    if (station.tun.gone()) forget(station.tun, station.end);
    if (packet.empty()) return;
    is_for_station(packet) ? send_on_wire(packet) : send_down(packet);
  }
}

bool Emulator::is_for_station(const Bytes& packet) const {
  const std::uint32_t destination = destination_of(packet);
  return std::any_of(stations_.begin(), stations_.end(),
                     [&](const Station& one) { return one.address == destination; });
}

/// With one station all is for it, as on a wire.
void Emulator::send_on_wire(const Bytes& packet) {
  const bool to_all =
      stations_.size() == 1 || is_group_addressed(packet, options_.stations.front().prefix);
  const std::uint32_t destination = destination_of(packet);
  for (Station& station : stations_) {
    if (!to_all && station.address != destination) continue;
    if (!station.tun.write(packet)) ++counters_.write_errors;
  }
}

/// To a group it goes to each vehicle by itself. With one vehicle all is for it, as on a wire.
void Emulator::send_down(const Bytes& packet) {
  const bool to_all =
      vehicles_.size() == 1 || is_group_addressed(packet, options_.stations.front().prefix);
  const std::uint32_t destination = destination_of(packet);
  for (std::size_t i = 0; i < vehicles_.size(); ++i) {
    if (to_all || vehicles_[i].address == destination) push(radio::Direction::downlink, i, packet);
  }
}

void Emulator::push(radio::Direction direction, std::size_t vehicle, Bytes packet) {
  const bool up = direction == radio::Direction::uplink;
  const int prefix = up ? vehicles_[vehicle].end.prefix : options_.stations.front().prefix;
  const radio::Packet on_air{static_cast<int>(packet.size()), is_group_addressed(packet, prefix),
                             radio::access_category_of_dscp(dscp_of(packet)), vehicle};
  packets_[channel_.push(direction, on_air, clock_now())] = std::move(packet);
}

/// A descriptor of an interface that is gone is readable for ever.
void Emulator::forget(const Tun& tun, const End& end) {
  ::epoll_ctl(epoll_.get(), EPOLL_CTL_DEL, tun.fd(), nullptr);
  std::fprintf(stderr,
               "link_emulator: the interface %s of %s was deleted; nothing passes until this "
               "program is started again\n",
               options_.interface.c_str(), end.name.c_str());
}

void Emulator::deliver() {
  channel_.advance(clock_now());
  while (const auto outcome = channel_.take()) {
    const auto packet = packets_.find(outcome->id);
    const Bytes bytes = std::move(packet->second);
    packets_.erase(packet);
    if (outcome->fate == radio::Fate::delivered) deliver(*outcome, bytes);
  }
}

/// The access point sends on what a vehicle sends to another one.
void Emulator::deliver(const radio::Outcome& outcome, const Bytes& packet) {
  const bool up = outcome.direction == radio::Direction::uplink;
  const std::uint32_t destination = destination_of(packet);
  const bool is_for_vehicle =
      up && std::any_of(vehicles_.begin(), vehicles_.end(),
                        [&](const Vehicle& one) { return one.address == destination; });
  if (is_for_vehicle) return send_down(packet);
  if (up) return send_on_wire(packet);
  if (!vehicles_[outcome.vehicle].tun.write(packet)) ++counters_.write_errors;
}

void Emulator::obey(const std::string& datagram, std::size_t vehicle) {
  ++counters_.commands;
  const Command command = parse_command(datagram);
  if (const auto* move = std::get_if<MoveTo>(&command)) {
    channel_.set_position(move->x_m, move->y_m, vehicle);
  } else if (const auto* outage = std::get_if<BeginOutage>(&command)) {
    channel_.begin_outage(clock_now(), seconds(outage->length_s));
  } else if (const auto* set = std::get_if<SetParameter>(&command)) {
    apply(*set);
  } else {
    ++counters_.bad_commands;
  }
}

void Emulator::apply(const SetParameter& command) {
  radio::ChannelParams params = channel_.params();
  if (set_parameter(params, command)) {
    channel_.configure(params);
  } else {
    ++counters_.bad_commands;
  }
}

/// Readers see the old text or the new one. Once a second, so without waiting for the disk.
std::error_code Emulator::write_wireless(const Vehicle& vehicle, const std::string& text) {
  if (vehicle.wireless_path.empty()) return {};
  return replace_file(vehicle.wireless_path, text, Sync::no);
}

void Emulator::report() {
  const Time now = clock_now();
  for (std::size_t i = 0; i < vehicles_.size(); ++i) report(i, now);
  counters_.late = Duration::zero();
  report_at_ = std::max(report_at_ + report_period, now);
}

void Emulator::report(std::size_t index, Time now) {
  const Vehicle& vehicle = vehicles_[index];
  const radio::LinkReport link = channel_.report(now, index);
  if (vehicle.stats) vehicle.stats->append(stats_line(to_seconds(now - start_), link, counters_));
  const std::string wireless =
      vehicle.tun.gone() ? wireless_head() : wireless_text(options_.interface, link);
  if (write_wireless(vehicle, wireless)) ++counters_.write_errors;
}

}  // namespace tocsin::link
