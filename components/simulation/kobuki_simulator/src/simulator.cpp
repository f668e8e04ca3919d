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

SimulatedBase make_base(const Options& options) {
  const Time now = monotonic_now();
  return {make_model(options, now), SerialLine(options.settings.line, options.seed + 1, now)};
}

}  // namespace

Simulator::Simulator(const Options& options)
    : options_(options),
      base_(make_base(options)),
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
  const Time soonest = std::min({base_.next_event(), next_report_, script_.next()});
  return options_.state.empty() ? soonest : std::min(soonest, next_save_);
}

void Simulator::play_script(Time now) {
  while (const auto command = script_.due(now)) {
    const std::string answer = obey_control(base_, *command, now);
    if (answer.rfind("error", 0) != 0) continue;
    std::fprintf(stderr, "kobuki_simulator: %s: %s\n", options_.script_file.c_str(),
                 answer.c_str());
  }
}

void Simulator::step(Time now) {
  play_script(now);
  base_.step(now, [this](ByteView packet) {
    if (terminal_->is_open()) terminal_->send(packet);
  });
  handle_cable(now);
  if (terminal_->is_open()) read_terminal(now);
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

void Simulator::read_terminal(Time now) {
  std::array<std::uint8_t, 512> bytes{};
  while (const std::size_t count = terminal_->receive(bytes.data(), bytes.size())) {
    base_.receive({bytes.data(), count}, now);
  }
}

void Simulator::read_control(Time now) {
  while (const auto message = control_->receive()) {
    const std::string answer = obey_control(base_, message->text, now);
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
