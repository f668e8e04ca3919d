// SPDX-License-Identifier: Apache-2.0
#include "session.hpp"

#include <poll.h>

#include <algorithm>
#include <array>
#include <csignal>

#include "foundation/error.hpp"
#include "kobuki_driver/serial_port.hpp"

namespace tocsin::kobuki {
namespace {

volatile std::sig_atomic_t stopped = 0;

void on_signal(int) { stopped = 1; }

}  // namespace

Session::Session(const std::string& port) {
  Opened opened = open_serial_port(port);
  if (!opened.port) throw EnvironmentError(opened.reason);
  port_ = std::move(opened.port);
  driver_.on_port_open();
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

Session::~Session() {
  if (!lost_) driver_.farewell([this](ByteView bytes) { send(bytes); });
}

bool Session::over() const { return lost_ || stopped != 0; }

std::optional<char> Session::key() {
  const auto pressed = key_;
  key_.reset();
  return pressed;
}

void Session::send(ByteView bytes) {
  if (!port_->write(bytes)) lost_ = true;
}

void Session::read(Time now) {
  std::array<std::uint8_t, 1024> bytes{};
  const auto count = port_->read(bytes.data(), bytes.size());
  if (!count) lost_ = true;
  if (!count || *count == 0) return;
  driver_.on_bytes({bytes.data(), *count}, now, [this](const Reading& reading) {
    last_ = reading;
    ++readings_;
    sink_(reading);
  });
}

void Session::wait(Time until) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - now());
  const int ms = static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, 1000));
  std::array<pollfd, 2> asked{{{port_->descriptor(), POLLIN, 0}, {keys_.descriptor(), POLLIN, 0}}};
  if (::poll(asked.data(), asked.size(), ms) < 0) return;
  if (asked[1].revents != 0) {
    if (const auto pressed = keys_.read()) key_ = pressed;
  }
}

bool Session::run_until(const std::function<bool()>& done, Duration limit) {
  const Time end = now() + limit;
  while (!done()) {
    if (over() || key_ || now() >= end) return false;
    wait(std::min(end, driver_.next_deadline()));
    read(now());
    driver_.run(now(), [this](ByteView bytes) { send(bytes); });
  }
  return true;
}

void Session::run_for(Duration duration) {
  (void)run_until([] { return false; }, duration);
}

}  // namespace tocsin::kobuki
