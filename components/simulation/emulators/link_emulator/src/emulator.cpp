// SPDX-License-Identifier: Apache-2.0
#include "emulator.hpp"

#include <sys/epoll.h>
#include <sys/signalfd.h>
#include <sys/timerfd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>

#include "foundation/error.hpp"
#include "foundation/replace_file.hpp"
#include "foundation/role.hpp"
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
  return {radio::load_channel(options.channel_file), std::move(walls), options.seed, start};
}

Emulator::Emulator(const Options& options)
    : options_(options),
      signals_(stop_signals()),
      epoll_(::epoll_create1(EPOLL_CLOEXEC)),
      timer_(::timerfd_create(CLOCK_MONOTONIC, TFD_NONBLOCK | TFD_CLOEXEC)),
      start_(clock_now()),
      channel_(make_channel(options, start_)),
      uxv_(options.uxv, options.interface),
      gcs_(options.gcs, options.interface),
      tick_at_(start_ + tick_period),
      report_at_(start_ + report_period) {
  if (!options.control_path.empty()) {
    control_ = std::make_unique<DatagramSocket>(options.control_path);
    watch(control_->descriptor());
  }
  if (!options.stats_path.empty()) stats_ = std::make_unique<StatsFile>(options.stats_path);
  if (const auto error =
          write_wireless(wireless_text(options.interface, channel_.report(start_)))) {
    throw ConfigError("--wireless " + options.wireless_path + ": " + error.message());
  }
  for (const int fd : {signals_.get(), timer_.get(), uxv_.fd(), gcs_.fd()}) watch(fd);
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
  uxv_.remove_at_end();
  gcs_.remove_at_end();
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
  if (fd == uxv_.fd()) carry(radio::Direction::uplink);
  if (fd == gcs_.fd()) carry(radio::Direction::downlink);
  if (fd == signals_.get()) running_ = false;
  if (!control_ || fd != control_->descriptor()) return;
  while (const auto message = control_->receive()) obey(message->text);
}

void Emulator::carry(radio::Direction direction) {
  const bool up = direction == radio::Direction::uplink;
  Tun& from = up ? uxv_ : gcs_;
  const int prefix = up ? options_.uxv.prefix : options_.gcs.prefix;
  for (int i = 0; i < packets_per_wake_up; ++i) {
    auto packet = from.read();
    if (from.gone()) forget(from, to_string(up ? Role::uxv : Role::gcs));
    if (packet.empty()) return;
    const radio::Packet on_air{static_cast<int>(packet.size()), is_group_addressed(packet, prefix),
                               radio::access_category_of_dscp(dscp_of(packet))};
    packets_[channel_.push(direction, on_air, clock_now())] = std::move(packet);
  }
}

/// A descriptor of an interface that is gone is readable for ever.
void Emulator::forget(const Tun& end, const std::string& name) {
  ::epoll_ctl(epoll_.get(), EPOLL_CTL_DEL, end.fd(), nullptr);
  std::fprintf(stderr,
               "link_emulator: the interface %s of %s was deleted; nothing passes until this "
               "program is started again\n",
               options_.interface.c_str(), name.c_str());
}

void Emulator::deliver() {
  channel_.advance(clock_now());
  while (const auto outcome = channel_.take()) {
    const auto packet = packets_.find(outcome->id);
    if (outcome->fate == radio::Fate::delivered) {
      Tun& to = outcome->direction == radio::Direction::uplink ? gcs_ : uxv_;
      if (!to.write(packet->second)) ++counters_.write_errors;
    }
    packets_.erase(packet);
  }
}

void Emulator::obey(const std::string& datagram) {
  ++counters_.commands;
  const Command command = parse_command(datagram);
  if (const auto* move = std::get_if<MoveTo>(&command)) {
    channel_.set_position(move->x_m, move->y_m);
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
std::error_code Emulator::write_wireless(const std::string& text) const {
  if (options_.wireless_path.empty()) return {};
  return replace_file(options_.wireless_path, text, Sync::no);
}

void Emulator::report() {
  const Time now = clock_now();
  const radio::LinkReport link = channel_.report(now);
  if (stats_) stats_->append(stats_line(to_seconds(now - start_), link, counters_));
  const std::string wireless =
      uxv_.gone() ? wireless_head() : wireless_text(options_.interface, link);
  if (write_wireless(wireless)) ++counters_.write_errors;
  counters_.late = Duration::zero();
  report_at_ = std::max(report_at_ + report_period, now);
}

}  // namespace tocsin::link
