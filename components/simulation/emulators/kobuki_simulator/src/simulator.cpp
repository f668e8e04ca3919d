// SPDX-License-Identifier: Apache-2.0
#include "simulator.hpp"

#include <sys/epoll.h>
#include <sys/signalfd.h>
#include <sys/timerfd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <utility>

#include "control.hpp"
#include "foundation/error.hpp"

namespace tocsin::kobuki {
namespace {

constexpr auto report_period = std::chrono::milliseconds(100);

Time monotonic_now() { return std::chrono::steady_clock::now(); }

FileDescriptor open_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGTERM);
  sigaddset(&set, SIGINT);
  sigprocmask(SIG_BLOCK, &set, nullptr);
  return FileDescriptor(::signalfd(-1, &set, SFD_CLOEXEC));
}

double wall_s() {
  return to_seconds(
      std::chrono::duration_cast<Duration>(std::chrono::system_clock::now().time_since_epoch()));
}

SimulatedBase make_base(const Options& options, const laser::Room& room) {
  const Time now = monotonic_now();
  return {make_model(options, room, now), SerialLine(options.settings.line, options.seed + 1, now)};
}

}  // namespace

Simulator::Simulator(const Options& options)
    : options_(options),
      room_(make_room(options)),
      base_(make_base(options, room_)),
      script_(options.script, options.script_file, monotonic_now()),
      epoll_(::epoll_create1(EPOLL_CLOEXEC)),
      timer_(::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC | TFD_NONBLOCK)),
      signals_(open_signals()) {
  if (!epoll_ || !timer_ || !signals_) throw EnvironmentError("cannot open epoll or a timer");
  watch(timer_.get());
  watch(signals_.get());
  if (!options.control.empty()) {
    control_ = std::make_unique<DatagramSocket>(options.control);
    watch(control_->descriptor());
  }
  terminal_.emplace(options.link);
  watch(terminal_->descriptor());
  if (options.laser.link.empty()) return;
  laser_.emplace(options.laser, room_.seen(), options.seed + 2, monotonic_now());
  watch(laser_->descriptor());
}

void Simulator::watch(int descriptor) {
  epoll_event event{};
  event.events = EPOLLIN | EPOLLET;  // edges: a terminal that nobody uses hangs up all the time
  event.data.fd = descriptor;
  ::epoll_ctl(epoll_.get(), EPOLL_CTL_ADD, descriptor, &event);
}

void Simulator::arm_timer(Time at) {
  const auto since_boot = std::max(at.time_since_epoch(), Duration{1});
  const auto whole = std::chrono::duration_cast<std::chrono::seconds>(since_boot);
  itimerspec spec{};
  spec.it_value.tv_sec = whole.count();
  spec.it_value.tv_nsec = (since_boot - whole).count();
  ::timerfd_settime(timer_.get(), TFD_TIMER_ABSTIME, &spec, nullptr);
}

void Simulator::run() {
  std::array<epoll_event, 8> events{};
  for (;;) {
    const Time now = monotonic_now();
    step(now);
    arm_timer(next_wake());
    const int count = ::epoll_wait(epoll_.get(), events.data(), events.size(), -1);
    for (int i = 0; i < count; ++i) {
      if (events[static_cast<std::size_t>(i)].data.fd == signals_.get()) return;
    }
  }
}

Time Simulator::next_wake() const {
  Time soonest = std::min({base_.next_event(), next_report_, script_.next()});
  if (laser_) soonest = std::min(soonest, laser_->next_event());
  return options_.state.empty() ? soonest : std::min(soonest, next_save_);
}

void Simulator::play_script(Time now) {
  while (const auto command = script_.due(now)) {
    const std::string answer = obey(*command, now);
    if (answer.rfind("error", 0) != 0) continue;
    std::fprintf(stderr, "kobuki_simulator: %s: %s\n", options_.script_file.c_str(),
                 answer.c_str());
  }
}

void Simulator::step(Time now) {
  play_script(now);
  if (room_.set_time(wall_s())) base_.model().surroundings_moved();
  base_.step(now, [this](ByteView packet) {
    if (terminal_->is_open()) terminal_->send(packet);
  });
  handle_cable(now);
  if (terminal_->is_open()) read_terminal(now);
  if (laser_) step_laser(now);
  if (control_) read_control(now);
  if (now >= next_report_) report(now);
  if (!options_.state.empty() && now >= next_save_) save(now);
}

void Simulator::handle_cable(Time now) {
  if (!base_.plugged(now)) {
    terminal_->remove();
    return;
  }
  const bool in_use = terminal_->is_open() && terminal_->in_use();
  const bool left = was_in_use_ && !in_use;
  was_in_use_ = in_use;
  if (terminal_->is_open() && !left) return;
  terminal_->renew();
  watch(terminal_->descriptor());
}

void Simulator::step_laser(Time now) {
  if (laser_->step(base_.model(), now)) watch(laser_->descriptor());
}

std::string Simulator::obey(const std::string& line, Time now) {
  constexpr const char* prefix = "laser ";
  if (line.rfind(prefix, 0) != 0) return obey_control(base_, line, now);
  return laser_ ? laser_->obey(line.substr(6), now) : "error: this base has no laser (--laser)";
}

void Simulator::read_terminal(Time now) {
  std::array<std::uint8_t, 512> bytes{};
  while (const std::size_t count = terminal_->receive(bytes.data(), bytes.size())) {
    base_.receive({bytes.data(), count}, now);
  }
}

void Simulator::read_control(Time now) {
  while (const auto message = control_->receive()) {
    const std::string answer = obey(message->text, now);
    if (!message->sender.empty()) (void)control_->send(message->sender, answer);
  }
}

void Simulator::report(Time now) {
  next_report_ = now + report_period;
  if (options_.position.empty()) return;
  const geometry::Pose& pose = base_.model().pose();
  char text[64] = {};
  std::snprintf(text, sizeof text, "pos %.3f %.3f", pose.x_m, pose.y_m);
  (void)position_.send(options_.position, text);
}

void Simulator::save(Time now) {
  next_save_ = now + report_period;
  const bool was_saved =
      std::exchange(saved_, save_memory(options_.state, base_.model().memory(now)));
  if (saved_ == was_saved) return;
  std::fprintf(stderr, "kobuki_simulator: %s %s\n", options_.state.c_str(),
               saved_ ? "is written again" : "cannot be written; tried again");
}

}  // namespace tocsin::kobuki
